#include "modules/optimization/FallOver.h"

#include <algorithm>

#include "robot/BodyJoints.h"
#include "trials/StandUpOptions.h"

namespace plumbline {

MAKE_MODULE(FallOver)

namespace {

constexpr double margin = 0.02;  ///< to a joint's stops [rad]

}  // namespace

void FallOver::parametersChanged() {
  if (mostLean < leastLean) refuse("mostLean", "must not be below leastLean");
}

void FallOver::draw() {
  const OptimizationTrial& trial = *theOptimizationTrial;
  if (trial.number != number_) random_ = Random(trial.seed);
  number_ = trial.number;
  const StandUpOptions options = TaskOptions::ofLines(trial.options).as<StandUpOptions>();
  const RobotModel& robot = theRobotDescription->model;
  const auto within = [&](JointId joint, double angle) {
    const Link& link = robot.linkMovedBy(joint);
    return std::clamp(angle, link.lower + margin, link.upper - margin);
  };
  leaning_ = falling_ = theJointData->angles;
  const double lean = -options.side() * random_.uniform(leastLean, mostLean);
  for (const JointId joint : {lAnklePitch, rAnklePitch})
    leaning_[joint] = within(joint, leaning_[joint] + lean);
  for (int j = firstBodyJoint; j < maxJoints; ++j) {
    const auto joint = static_cast<JointId>(j);
    if (robot.has(joint)) falling_[joint] = within(joint, falling_[joint] + random_.uniform(-spread, spread));
  }
}

void FallOver::update(FallOverOutput* theFallOverOutput) {
  const MotionSelection& selection = *theMotionSelection;
  const bool selected = selection.motion == FallOverOutput::name;
  if (selected && selection.started) draw();
  JointTargets& targets = theFallOverOutput->targets;
  targets.angles = theFallState->posture == Posture::upright ? leaning_ : falling_;
  for (std::size_t j = 0; j < maxJoints; ++j)
    targets.set[j] = selected && theRobotDescription->model.has(static_cast<JointId>(j));
}

}  // namespace plumbline
