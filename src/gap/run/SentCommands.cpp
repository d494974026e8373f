#include "gap/run/SentCommands.h"

#include <algorithm>
#include <array>
#include <string>

namespace plumbline::gap {

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

bool isSentEfforts(const Run& run, const Mechanism::Joint& joint) {
  return std::ranges::any_of(
      std::array{ChannelKind::commandSpeed, ChannelKind::commandTorque, ChannelKind::commandCurrent},
      [&](ChannelKind kind) { return run.find(kind, joint.name) != nullptr; });
}

}  // namespace plumbline::gap
