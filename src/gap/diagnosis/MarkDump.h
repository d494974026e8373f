#pragma once
#include <array>
#include <bit>
#include <cstdint>
#include <string>
#include <type_traits>
#include <vector>

#include "gap/replay/Trial.h"

namespace plumbline::gap {

/// A hash (FNV-1a) over a canonical dump of robots and recordings: numbers by their bits, lists and texts
/// after their length. A structure is taken apart by a structured binding, which names all of its members or
/// does not compile.
class MarkDump {
public:
  void bytes(const char* data, std::size_t size) {
    for (std::size_t i = 0; i < size; ++i)
      hash_ = (hash_ ^ static_cast<unsigned char>(data[i])) * 0x100000001b3;
  }

  template <class... Values>
  void all(const Values&... values) {
    (add(values), ...);
  }

  template <class Value>
  requires std::is_arithmetic_v<Value> || std::is_enum_v<Value>
  void add(Value value) {
    const auto raw = std::bit_cast<std::array<char, sizeof value>>(value);
    bytes(raw.data(), raw.size());
  }
  void add(const std::string& text) {
    add(text.size());
    bytes(text.data(), text.size());
  }
  template <class Value>
  void add(const std::vector<Value>& values) {
    add(values.size());
    for (const Value& value : values) add(value);
  }
  template <class Scalar, int Rows, int Columns>
  void add(const Eigen::Matrix<Scalar, Rows, Columns>& matrix) {
    for (const Scalar value : matrix.reshaped()) add(value);
  }
  void add(const Pose3& pose) { add(Eigen::Matrix4d(pose.matrix())); }

  void add(const Servo& servo) {
    const auto& [model, kp, kd, armature, kt, R, vin, errorGain, kpFirmware, maxPwm, followsTorque] = servo;
    all(model, kp, kd, armature, kt, R, vin, errorGain, kpFirmware, maxPwm, followsTorque);
  }
  void add(const Mechanism::Link& link) {
    const auto& [name, parent, mass, com, inertia, shape, collides] = link;
    all(name, parent, mass, com, inertia, shape.has_value(), collides);
    if (shape) add(*shape);
  }
  void add(const Shape& shape) {
    const auto& [kind, size, T_link_shape] = shape;
    all(kind, size, T_link_shape);
  }
  void add(const Mechanism::Joint& joint) {
    const auto& [name, type, parent, child, origin, rpy, axis, lower, upper, maxTorque, maxSpeed, encoder,
                 servo, friction, damping, driver, driverRatio, driverOffset] = joint;
    all(name, type, parent, child, origin, rpy, axis, lower, upper, maxTorque, maxSpeed, encoder, servo,
        friction, damping, driver, driverRatio, driverOffset);
  }
  void add(const Mechanism::Imu& imu) {
    const auto& [link, gyro, accelerometer, rpy] = imu;
    all(link, gyro, accelerometer, rpy);
  }
  void add(const Mechanism::ForceSensor& sensor) {
    const auto& [corner, position] = sensor;
    all(corner, position);
  }
  void add(const Mechanism::Foot& foot) {
    const auto& [name, link, soleCentre, soleSize, sensors] = foot;
    all(name, link, soleCentre, soleSize, sensors);
  }
  void add(const Mechanism::Frame& frame) {
    const auto& [name, link, T_link_frame] = frame;
    all(name, link, T_link_frame);
  }
  void add(const Mechanism::Group& group) {
    const auto& [name, joints] = group;
    all(name, joints);
  }
  void add(const Mechanism& robot) {
    const auto& [name, links, joints, frames, feet, groups, imu, hasImu, gravity, controlHz] = robot;
    all(name, links, joints, frames, feet, groups, imu, hasImu, gravity, controlHz);
  }

  void add(const Signal& signal) {
    const auto& [name, kind, joint, place, axis, unsignedValue, values, ofSupply] = signal;
    all(name, kind, joint, place, axis, unsignedValue, values, ofSupply);
  }
  void add(const Restart& restart) {
    const auto& [cycle, position, speed, load] = restart;
    all(cycle, position, speed, load);
  }
  void add(const Trial& trial) {
    const auto& [name, recording, motion, recordedMotion, robot, freeBase, heading, time, command, followed,
                 commandSpeed, commandTorque, linearCommands, stiffness, voltage, commandAt, positionAt,
                 velocityAt, effortAt, signals, unused, restarts, lost, betweenSteps] = trial;
    all(name, recording, motion, recordedMotion, *robot, freeBase, heading, time, command, followed,
        commandSpeed, commandTorque, linearCommands, stiffness, voltage, commandAt, positionAt, velocityAt,
        effortAt, signals, unused, restarts, lost, betweenSteps);
  }
  /// The program's file, which every change of the sources changes.
  void addProgram();
  /// Of the effects in the library: their names.
  void addLibrary();

  /// The hash in sixteen digits.
  std::string text() const;

private:
  std::uint64_t hash_ = 0xcbf29ce484222325;
};

}  // namespace plumbline::gap
