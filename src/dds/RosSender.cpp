#include "dds/RosSender.h"

namespace plumbline::dds {

RosSender::RosSender(const ParticipantOptions& options, const std::string& prefix) : participant_(options) {
  const auto open = [&](RosTopic topic, const std::string& name, const char* package, const char* message,
                        bool lasting = false) {
    // Frames have one topic for all robots; their names carry the prefix.
    const std::string path = topic == RosTopic::frames ? name : prefix + name;
    outgoing_[static_cast<std::size_t>(topic)].writer =
        std::make_unique<ByteWriter>(participant_, ros::topicName(path, package, message, lasting));
  };
  open(RosTopic::joints, "joint_states", "sensor_msgs", "JointState");
  open(RosTopic::inertial, "imu", "sensor_msgs", "Imu");
  open(RosTopic::odometry, "odom", "nav_msgs", "Odometry");
  open(RosTopic::frames, "tf", "tf2_msgs", "TFMessage");
  open(RosTopic::ball, "ball", "geometry_msgs", "PointStamped");
  open(RosTopic::description, "robot_description", "std_msgs", "String", true);
}

void RosSender::send(RosTopic topic, std::string message) {
  Outgoing& out = outgoing_[static_cast<std::size_t>(topic)];
  out.newest.writing().bytes = std::move(message);
  out.newest.publish();
}

void RosSender::sendAll() {
  for (Outgoing& out : outgoing_) {
    if (out.newest.take()) out.writer->write(out.newest.reading());
  }
}

}  // namespace plumbline::dds
