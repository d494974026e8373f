#include "main/gap/WalkRecording.h"

#include <algorithm>
#include <stdexcept>

#include "framework/ConfigurationError.h"
#include "gap/record/BulletRecording.h"
#include "gap/replay/TrialOf.h"
#include "gap/replay/TruePose.h"
#include "training/ServoWalker.h"

namespace plumbline::gap {

namespace {

constexpr double standing = 1, walking_ = 10;  // [s]

struct Cycle {
  walking::ServoMeasurement measured;
  walking::ServoCommand command;
  Pose3 torso;
};

/// A plant that remembers what it was told and what it told. Joints of one motor are told the same.
class RecordedPlant : public walking::BulletPlant {
public:
  /// The robot must outlive it.
  RecordedPlant(const Mechanism& robot_, const Plant& plant)
      : BulletPlant(bulletMechanism(plant, robot_.controlHz), bulletWorld(plant, false)), robot(robot_) {}

  void command(const walking::ServoCommand& asked) override {
    walking::ServoCommand given = asked;
    for (std::size_t j = 0; j < given.target.size(); ++j)
      if (const Mechanism::Joint& joint = robot.joints[j]; joint.driver >= 0)
        given.target[j] = joint.driven(given.target[static_cast<std::size_t>(joint.driver)]);
    cycles.push_back({measure(), given, torso()});
    BulletPlant::command(given);
  }
  std::vector<Cycle> cycles;

private:
  const Mechanism& robot;
};

walking::WalkRequest requestOf(const std::string& program) {
  walking::WalkRequest request;
  request.walk = true;
  if (program == "walk_forward")
    request.velocity = Vec2(0.15, 0);
  else if (program == "walk_sideways")
    request.velocity = Vec2(0, 0.06);
  else if (program == "walk_turn")
    request.turn = 0.4;
  else
    throw std::invalid_argument("there is no walk " + program);
  return request;
}

void check(const Explanation& effects) {
  for (const Cause& cause : effects) {
    if (std::ranges::find(walkEffects(), cause.effect->id) == walkEffects().end())
      throw ConfigurationError("a walk is recorded with effects of drives, links and ground; " +
                               std::string(cause.effect->id) + " is none; other programs have it");
  }
}

}  // namespace

const std::vector<std::string>& walkPrograms() {
  static const std::vector<std::string> names = {"walk_forward", "walk_sideways", "walk_turn"};
  return names;
}

Run recordWalk(const Mechanism& robot, const std::string& program, const SimulatedRecordingOptions& options) {
  check(options.effects);
  const walking::WalkRequest request = requestOf(program);
  const Plant plant = plantOf(robot, options.effects);
  auto owned = std::make_unique<RecordedPlant>(robot, plant);
  RecordedPlant& recorded = *owned;
  walking::ServoWalker walker(robot, walking::readServoGaits(robot.name), std::move(owned));
  recorded.cycles.clear();
  if (!walker.run({}, standing) || !walker.run(request, walking_) || !walker.run({}, standing))
    throw std::runtime_error(
        program + ": " + robot.name + " fell over after " +
        std::to_string(static_cast<int>(static_cast<double>(recorded.cycles.size()) / robot.controlHz)) +
        " s; nothing was written");

  Excitation shape;  // of the run: its channels and times
  shape.name = program;
  shape.about = program + ": the project's own walk, closed loop";
  shape.freeBase = true;
  shape.posture.assign(robot.joints.size(), 0);
  shape.duration = (static_cast<double>(recorded.cycles.size()) - 1) / robot.controlHz;
  Run run = blankRun(robot, shape, robot.controlHz, options.truth);
  const std::size_t n = std::min(run.size(), recorded.cycles.size());
  for (std::size_t j = 0; j < robot.joints.size(); ++j) {
    auto& command = run.channels[channelName(ChannelKind::command, robot.joints[j].name)];
    auto& stiffness = run.channels[channelName(ChannelKind::stiffness, robot.joints[j].name)];
    stiffness.resize(run.size(), 1);
    for (std::size_t k = 0; k < n; ++k) {
      const walking::ServoCommand& c = recorded.cycles[k].command;
      command[k] = c.target[j];
      if (j < c.stiffness.size()) stiffness[k] = c.stiffness[j];
    }
  }
  const Trial trial = trialOf(run, robot);
  for (const Signal& signal : trial.signals) {
    std::vector<double>& values = run.channels[signal.name];
    for (std::size_t k = 0; k < n; ++k) {
      const Cycle& cycle = recorded.cycles[k];
      const auto place = static_cast<std::size_t>(std::max(0, signal.place)),
                 axis = static_cast<std::size_t>(signal.axis);
      if (signal.kind == SignalKind::position)
        values[k] = cycle.measured.position[static_cast<std::size_t>(signal.joint)];
      else if (signal.kind == SignalKind::gyro)
        values[k] = cycle.measured.gyro[signal.axis];
      else if (signal.kind == SignalKind::accelerometer)
        values[k] = cycle.measured.acc[signal.axis];
      else if (signal.kind == SignalKind::force)
        values[k] = plant.footGain[place] * cycle.measured.footForce[place][axis];
      else if (signal.kind == SignalKind::truth)
        values[k] = poseValues(cycle.torso)[axis];
    }
    if (options.noisy) addNoise(signal, options.noise, options.seed, values);
  }
  return run;
}

}  // namespace plumbline::gap
