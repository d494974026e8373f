#include "dds/RosSender.h"

namespace plumbline::dds {
namespace {
constexpr unsigned indexMask = 3, fresh = 4;
}

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
  out.samples[out.writing].bytes = std::move(message);
  out.writing = out.middle.exchange(out.writing | fresh, std::memory_order_acq_rel) & indexMask;
}

void RosSender::sendAll() {
  for (Outgoing& out : outgoing_) {
    if (!(out.middle.load(std::memory_order_relaxed) & fresh)) continue;
    out.reading = out.middle.exchange(out.reading, std::memory_order_acq_rel) & indexMask;
    out.writer->write(out.samples[out.reading]);
  }
}

}  // namespace plumbline::dds
