#include "modules/infrastructure/RosBridge.h"

#include <algorithm>
#include <cctype>
#include <stdexcept>

#include "framework/ConfigurationError.h"
#include "robot/UrdfWriter.h"

namespace plumbline {

MAKE_MODULE(RosBridge)

namespace {

namespace ros = dds::ros;

ros::Vector vectorOf(const Vec3& v) { return {v.x(), v.y(), v.z()}; }

ros::Quaternion quaternionOf(const Mat3& rotation) {
  const Eigen::Quaterniond q(rotation);
  return {q.x(), q.y(), q.z(), q.w()};
}

Pose3 pose3Of(const Pose2& pose) {
  return translation(pose.position.x(), pose.position.y(), 0) * rotationZ(pose.heading);
}

}  // namespace

void RosBridge::init() {
  if (!std::ranges::all_of(space, [](unsigned char c) { return std::isalnum(c) || c == '_'; }))
    throw ConfigurationError("RosBridge.space is no name of ROS 2: letters, digits and _");
  dds::ParticipantOptions options;
  options.domain = static_cast<unsigned>(domain);
  options.addresses = addresses;
  options.peers = peers;
  options.open = true;
  try {
    sender_ = std::make_unique<dds::RosSender>(options, space.empty() ? "" : space + "/");
  } catch (const std::runtime_error& error) {
    throw ConfigurationError("RosBridge: " + std::string(error.what()));
  }
}

std::string RosBridge::frame(const std::string& name) const {
  return space.empty() ? name : space + "/" + name;
}

ros::Header RosBridge::header(const std::string& name) const { return {theFrameInfo->time, frame(name)}; }

void RosBridge::execute() {
  if (theFrameInfo->cycle == 0) return;  // nothing was measured yet
  if (theRobotDescription && theRobotDescription->known() && theRobotDescription->name != described_) {
    described_ = theRobotDescription->name;
    sender_->send(dds::RosTopic::description, ros::encode(urdfOf(theRobotDescription->model)));
  }
  if (theJointData) sendJoints();
  if (theSensorData) sendInertial();
  if (theOdometry) sendOdometry();
  if (theBallPos && theBallPos->valid) sendBall();
  sendFrames();
  sender_->wake();
}

void RosBridge::sendJoints() {
  ros::JointState message;
  message.header = header("torso");
  static const RobotModel unknown;
  const bool known = theRobotDescription && theRobotDescription->known();
  const RobotModel& robot = known ? theRobotDescription->model : unknown;
  for (int j = 0; j < maxJoints; ++j) {
    const auto joint = static_cast<JointId>(j);
    if (known ? !robot.has(joint) : joint >= numHumanoidJoints) continue;
    message.names.emplace_back(robot.jointName(joint));
    message.positions.push_back(theJointData->angles[joint]);
  }
  sender_->send(dds::RosTopic::joints, ros::encode(message));
}

void RosBridge::sendInertial() {
  ros::Imu message;
  message.header = header("torso");
  message.orientationCovariance[0] = -1;  // the sensor has none
  message.angularVelocity = vectorOf(theSensorData->gyro);
  message.linearAcceleration = vectorOf(theSensorData->acc);
  sender_->send(dds::RosTopic::inertial, ros::encode(message));
}

void RosBridge::sendOdometry() {
  ros::Odometry message;
  message.header = header("odom");
  message.childFrame = frame("base_footprint");
  const Pose3 pose = pose3Of(theOdometry->total);
  message.position = vectorOf(pose.translation());
  message.orientation = quaternionOf(pose.linear());
  const double seconds = theFrameInfo->cycleSeconds;
  if (seconds > 0) {
    const Pose2& step = theOdometry->step;
    message.linear = {step.position.x() / seconds, step.position.y() / seconds, 0};
    message.angular = {0, 0, step.heading / seconds};
  }
  sender_->send(dds::RosTopic::odometry, ros::encode(message));
}

void RosBridge::sendFrames() {
  std::vector<ros::Transform> transforms;
  const auto add = [&](const std::string& parent, const std::string& child, const Pose3& pose) {
    transforms.push_back(
        {header(parent), frame(child), vectorOf(pose.translation()), quaternionOf(pose.linear())});
  };
  if (theOdometry) {
    const Pose3 T_odom_robot = pose3Of(theOdometry->total);
    if (theRobotPose && theRobotPose->valid)
      add("map", "odom", pose3Of(theRobotPose->pose) * T_odom_robot.inverse());
    add("odom", "base_footprint", T_odom_robot);
  }
  if (theTorsoPose) add("base_footprint", "torso", theTorsoPose->T_ground_torso);
  if (theFKModel) {
    add("torso", "l_sole", theFKModel->T_torso_leftSole);
    add("torso", "r_sole", theFKModel->T_torso_rightSole);
  }
  if (!transforms.empty()) sender_->send(dds::RosTopic::frames, ros::encode(transforms));
}

void RosBridge::sendBall() {
  ros::PointStamped message{header("base_footprint"),
                            {theBallPos->relative.x(), theBallPos->relative.y(), 0}};
  sender_->send(dds::RosTopic::ball, ros::encode(message));
}

}  // namespace plumbline
