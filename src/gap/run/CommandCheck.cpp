#include "gap/run/CommandCheck.h"

namespace plumbline::gap {

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
