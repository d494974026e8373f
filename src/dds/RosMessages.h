#pragma once
#include <array>
#include <string>
#include <vector>

#include "dds/ByteTopic.h"

// Messages of ROS 2 (common_interfaces and tf2_msgs, the same from Foxy to Jazzy) as far as agents send them.
// encode() gives their CDR without the header that BytesType puts in front.
namespace plumbline::dds::ros {

/// std_msgs/Header: when [s since the platform's start] and in which frame.
struct Header {
  double time = 0;
  std::string frame;
};

struct Vector {
  double x = 0, y = 0, z = 0;
};

struct Quaternion {
  double x = 0, y = 0, z = 0, w = 1;
};

/// sensor_msgs/JointState: angles [rad]; speeds and torques may be left empty, as the definition allows.
struct JointState {
  Header header;
  std::vector<std::string> names;
  std::vector<double> positions, velocities, efforts;
};

/// sensor_msgs/Imu: a covariance whose first number is -1 says that the value is not measured.
struct Imu {
  Header header;
  Quaternion orientation;
  std::array<double, 9> orientationCovariance{};
  Vector angularVelocity;  ///< [rad/s]
  std::array<double, 9> angularVelocityCovariance{};
  Vector linearAcceleration;  ///< [m/s^2]
  std::array<double, 9> linearAccelerationCovariance{};
};

/// nav_msgs/Odometry, of a pose and a speed of the child frame; no covariances are known.
struct Odometry {
  Header header;
  std::string childFrame;
  Vector position;
  Quaternion orientation;
  Vector linear, angular;  ///< in the child frame [m/s], [rad/s]
};

/// geometry_msgs/TransformStamped: T_frame_childFrame.
struct Transform {
  Header header;
  std::string childFrame;
  Vector translation;
  Quaternion rotation;
};

/// geometry_msgs/PointStamped.
struct PointStamped {
  Header header;
  Vector point;
};

std::string encode(const JointState& message);
std::string encode(const Imu& message);
std::string encode(const Odometry& message);
/// tf2_msgs/TFMessage.
std::string encode(const std::vector<Transform>& transforms);
std::string encode(const PointStamped& message);
/// std_msgs/String.
std::string encode(const std::string& text);

/// Topic and type on the wire, by ROS 2's rules: topicName("robot1/imu", "sensor_msgs", "Imu"). Reliable, as
/// readers of ROS 2 want it; the last message waits for readers who come later if it is `lasting`.
TopicName topicName(const std::string& topic, const std::string& package, const std::string& message,
                    bool lasting = false);

}  // namespace plumbline::dds::ros
