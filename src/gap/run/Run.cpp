#include "gap/run/Run.h"

#include <cmath>

#include "framework/SingleLine.h"

namespace plumbline::gap {

// Names and cells come from files: what is no letter there must not break the line.
RunError::RunError(const std::string& what) : ConfigurationError(singleLine(what)) {}

std::string RunWarning::line(const std::string& folder) const {
  return singleLine(folder + ": " + channel + (leftOut ? " is left out: " : ": ") + why);
}

const std::vector<double>* Run::find(const std::string& channel) const {
  const auto it = channels.find(channel);
  return it == channels.end() ? nullptr : &it->second;
}

JointTiming Run::timingOf(const std::string& joint) const {
  auto it = timing.find(joint);
  if (it == timing.end()) it = timing.find("*");
  return it == timing.end() ? JointTiming{} : it->second;
}

bool Run::isUnsigned(const std::string& channel) const {
  return unsignedKinds.count(channel) || unsignedKinds.count(channel.substr(0, channel.find('.')));
}

std::vector<double> Run::stiffnessOf(const std::string& joint) const {
  std::vector<double> result(size(), 1.0);
  const std::vector<double>* column = find(ChannelKind::stiffness, joint);
  if (!column) return result;
  double last = 1;
  for (std::size_t i = 0; i < result.size(); ++i) {
    if (!std::isnan((*column)[i])) last = (*column)[i];
    result[i] = last;
  }
  return result;
}

std::vector<std::string> Run::jointsWith(ChannelKind kind) const {
  std::vector<std::string> joints;
  for (const auto& [name, column] : channels)
    if (const auto channel = parseChannel(name); channel && channel->kind == kind)
      joints.push_back(channel->place);
  return joints;
}

Mechanism withServo(Mechanism robot, const Run& run) {
  for (const auto& [name, given] : run.servo) {
    const int index = robot.jointIndex(name);
    if (index < 0) continue;
    Mechanism::Joint& joint = robot.joints[static_cast<std::size_t>(index)];
    Servo& servo = joint.servo;
    const auto linearGain = [&] {
      return servo.kt * servo.vin * servo.errorGain * servo.kpFirmware / servo.R;
    };
    servo.armature = given.armature.value_or(servo.armature);
    joint.maxTorque = given.maxTorque.value_or(joint.maxTorque);
    joint.maxSpeed = given.maxSpeed.value_or(joint.maxSpeed);
    servo.vin = given.vin.value_or(servo.vin);
    servo.kpFirmware = given.kpFirmware.value_or(servo.kpFirmware);
    servo.kd = given.kd.value_or(servo.kd);
    if (given.kp) {
      if (servo.R > 0 && !given.kpFirmware && linearGain() > 0) servo.kpFirmware *= *given.kp / linearGain();
      servo.kp = *given.kp;
    } else if (servo.R > 0 && (given.kpFirmware || given.vin)) {
      servo.kp = linearGain();
    }
  }
  return robot;
}

}  // namespace plumbline::gap
