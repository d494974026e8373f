#include <stdexcept>

#include "gap/effects/Effect.h"

namespace plumbline::gap {

namespace {

/// A target that is too low by value / kp pulls as the value does, while nothing saturates.
void lowerTarget(const ModelAndRuns& data, const Place& place, double value) {
  const Mechanism::Joint& joint = data.robot.joints[static_cast<std::size_t>(place.index)];
  if (!hasLinearServo(data.robot, place)) throw std::runtime_error("its law is not linear");
  for (Run& run : data.runs) {
    if (run.find(ChannelKind::stiffness, joint.name)) throw std::runtime_error("the motor is off at times");
    const auto own = run.servo.find(joint.name);
    const double kp = own == run.servo.end() ? joint.servo.kp : own->second.kp.value_or(joint.servo.kp);
    shiftChannel(run, ChannelKind::command, joint.name, -value / kp);
  }
}

}  // namespace

/// A spring, a cable or a wrong zero of torque.
const Effect biasForce{
    .id = "bias_force",
    .order = 160,
    .unit = "N m",
    .sites = {Site::joint},
    .lower = -0.6,
    .upper = 0.6,
    .starts = {-0.1, 0.1},
    .linear = true,
    .sentence = "A constant torque pulls at {at}.",
    .exposedBy = "static poses",
    .scale = [](const Mechanism& m,
                const Place& p) { return m.joints[static_cast<std::size_t>(p.index)].maxTorque; },
    .apply = [](Plant& plant, const Place& place, double value,
                int) { atJoints(plant, place, [value](JointPlant& joint) { joint.biasForce += value; }); },
    .inWalk = true,
    .alike = {"joint_offset", 14},
    .drawing = {.where = DrawRange::Where::joint,
                .low = 0.04,
                .high = 0.12,
                .unit = DrawRange::Unit::torque,
                .bothSigns = true},
    .perJointFit = {.rank = 100},
    .planting = {.rank = 11, .possible = hasLinearServo, .apply = lowerTarget},
};
MAKE_EFFECT(biasForce);

}  // namespace plumbline::gap
