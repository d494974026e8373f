#include "gap/run/CommandCheck.h"

#include <algorithm>
#include <array>

namespace plumbline::gap {

namespace {

/// Whether a joint's servo, with the gains of the run, is driven by the speeds that it was sent alone.
bool takesSpeeds(const Run& run, const Mechanism::Joint& joint) {
  return joint.servo.model == Servo::Model::position && joint.servo.kd > 0 &&
         run.find(ChannelKind::commandSpeed, joint.name) && !run.find(ChannelKind::command, joint.name);
}

}  // namespace

void leaveOutUselessCommands(Run& run, const Mechanism::Joint& joint, std::vector<RunWarning>& warnings) {
  const auto leaveOut = [&](ChannelKind kind, const std::string& why) {
    const std::string channel = channelName(kind, joint.name);
    if (run.channels.erase(channel)) warnings.push_back({channel, true, why});
  };
  const bool dcMotor = joint.servo.model == Servo::Model::dcMotor;
  if (dcMotor) leaveOut(ChannelKind::commandSpeed, "a DC motor's law has none");
  if (dcMotor && run.find(ChannelKind::command, joint.name))
    for (const ChannelKind kind : {ChannelKind::commandTorque, ChannelKind::commandCurrent})
      leaveOut(kind, "a DC motor that is sent positions has no use for it; without cmd." + joint.name +
                         " it follows torques or currents");
  if (run.find(ChannelKind::commandTorque, joint.name))
    leaveOut(ChannelKind::commandCurrent, "cmd_torque." + joint.name + " is used");
  if (!dcMotor && !run.find(ChannelKind::command, joint.name) && !takesSpeeds(run, joint))
    leaveOut(ChannelKind::commandSpeed, "its servo has no damping (kd), so speeds do not drive it");
  if (!(joint.servo.kt > 0))
    leaveOut(ChannelKind::commandCurrent, "the robot's file gives no torque per ampere (servo.kt)");
}

bool wasSentSpeedOrTorque(const Run& run, const std::string& joint) {
  return std::ranges::any_of(
      std::array{ChannelKind::commandSpeed, ChannelKind::commandTorque, ChannelKind::commandCurrent},
      [&](ChannelKind kind) { return run.find(kind, joint) != nullptr; });
}

void checkCommands(const Run& run, const Mechanism& robot) {
  const Mechanism driven = withServo(robot, run);
  for (std::size_t j = 0; j < driven.joints.size(); ++j) {
    const Mechanism::Joint& joint = driven.joints[j];
    if (robot.joints[j].servo.kp > 0 || joint.servo.kp > 0 || joint.driver >= 0) continue;
    const auto has = [&](ChannelKind kind) { return run.find(kind, joint.name) != nullptr; };
    const std::string refusal =
        run.folder + ": joint " + joint.name + " has no position gain in the file of " + robot.name + ", ";
    if (has(ChannelKind::command))
      throw RunError(refusal + "but cmd." + joint.name +
                     " was sent; give kp and kd of its controller under servo in "
                     "run.json, or record cmd_torque." +
                     joint.name + " instead");
    if (has(ChannelKind::commandTorque) || has(ChannelKind::commandCurrent) || takesSpeeds(run, joint))
      continue;
    throw RunError(refusal + "and there is no cmd_torque." + joint.name +
                   (joint.servo.kd > 0 ? " or cmd_vel." + joint.name : "") +
                   "; record it, 0 while the motor is off");
  }
}

}  // namespace plumbline::gap
