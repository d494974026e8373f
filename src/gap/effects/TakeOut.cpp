#include "gap/effects/TakeOut.h"

#include "gap/effects/Effect.h"

namespace plumbline::gap {

void changeServo(const ModelAndRuns& data, const Place& place,
                 const std::function<void(Mechanism::Joint&)>& model,
                 const std::function<void(ServoOverride&)>& run) {
  Mechanism::Joint& joint = data.robot.joints[static_cast<std::size_t>(place.index)];
  model(joint);
  for (Run& one : data.runs)
    if (const auto own = one.servo.find(joint.name); own != one.servo.end()) run(own->second);
}

void divide(std::optional<double>& value, double by) {
  if (value) *value /= by;
}

void shiftChannel(Run& run, ChannelKind kind, const std::string& joint, double by) {
  if (const auto column = run.channels.find(channelName(kind, joint)); column != run.channels.end())
    for (double& value : column->second) value += by;
}

void hastenCommands(Run& run, const std::string& joint, double by) {
  JointTiming timing = run.timingOf(joint);
  timing.cmdAt -= by;
  run.timing[joint] = timing;
}

bool hasLinearServo(const Mechanism& robot, const Place& place) {
  return robot.joints[static_cast<std::size_t>(place.index)].servo.model == Servo::Model::position;
}

}  // namespace plumbline::gap
