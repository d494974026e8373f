#include "gap/record/WalkRecording.h"

#include <algorithm>
#include <stdexcept>

#include "framework/ConfigurationError.h"
#include "framework/StopSignal.h"
#include "gap/record/EngineRecording.h"
#include "gap/replay/TrialOf.h"
#include "gap/replay/TruePose.h"

namespace plumbline::gap {

namespace {

struct Cycle {
  walking::ServoMeasurement measured;
  walking::ServoCommand command;
  Pose3 torso;
};

void check(const Explanation& effects) {
  for (const Cause& cause : effects) {
    if (!cause.effect->inWalk)
      throw ConfigurationError("a simulated walk can have effects of drives, links and ground only; " +
                               std::string(cause.effect->id) +
                               " is not one of these; record another program with it");
  }
}

}  // namespace

std::unique_ptr<training::ServoWalker> walkerWith(const std::string& engine, const Mechanism& robot,
                                                  const walking::WalkGaits& gaits,
                                                  const Explanation& effects) {
  check(effects);
  const Plant plant = plantOf(robot, effects);
  return std::make_unique<training::ServoWalker>(
      robot, gaits,
      servo::RobotSimulations::make(engine, engineMechanism(plant, robot.controlHz),
                                    engineOptions(plant, false)));
}

Run recordWalk(const std::string& engine, const Mechanism& robot, const Excitation& program,
               const SimulatedRecordingOptions& options) {
  if (!program.walk) throw std::invalid_argument(program.name + " is no walk");
  const auto robotThatWalks =
      walkerWith(engine, robot, training::readServoGaits(robot.name), options.effects);
  training::ServoWalker& walker = *robotThatWalks;
  const Plant plant = plantOf(robot, options.effects);
  std::vector<Cycle> cycles;
  walker.observer = [&](const walking::ServoMeasurement& measured, const walking::ServoCommand& command) {
    StopSignal::throwIfCaught();
    cycles.push_back({measured, command, walker.plant().base().pose});
  };
  walking::WalkRequest request;
  request.walk = true;
  request.velocity = program.walk->velocity;
  request.turn = program.walk->turn;
  if (!walker.run({}, program.walk->standBefore) || !walker.run(request, program.walk->duration) ||
      !walker.run({}, program.walk->standAfter))
    throw std::runtime_error(
        program.name + ": " + robot.name + " fell over after " +
        std::to_string(static_cast<int>(static_cast<double>(cycles.size()) / robot.controlHz)) +
        " s; nothing was written");

  Excitation shape = program;  // of the run: its channels and times
  shape.walk.reset();
  shape.duration = (static_cast<double>(cycles.size()) - 1) / robot.controlHz;
  Run run = blankRun(robot, shape, robot.controlHz, options.truth);
  const std::size_t n = std::min(run.size(), cycles.size());
  for (std::size_t j = 0; j < robot.joints.size(); ++j) {
    auto& command = run.channels[channelName(ChannelKind::command, robot.joints[j].name)];
    auto& stiffness = run.channels[channelName(ChannelKind::stiffness, robot.joints[j].name)];
    stiffness.resize(run.size(), 1);
    for (std::size_t k = 0; k < n; ++k) {
      const walking::ServoCommand& c = cycles[k].command;
      command[k] = c.target[j];
      if (j < c.stiffness.size()) stiffness[k] = c.stiffness[j];
    }
  }
  const Trial trial = trialOf(run, robot);
  for (const Signal& signal : trial.signals) {
    std::vector<double>& values = run.channels[signal.name];
    for (std::size_t k = 0; k < n; ++k) {
      const Cycle& cycle = cycles[k];
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
