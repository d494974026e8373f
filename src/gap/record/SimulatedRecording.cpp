#include "gap/record/SimulatedRecording.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

#include "gap/record/LostCommands.h"
#include "gap/replay/TrialOf.h"
#include "math/Random.h"

namespace plumbline::gap {

namespace {

/// One generator per channel, so that a channel more or less leaves the others as they are.
Random generatorOf(const std::string& channel, std::uint64_t seed) {
  std::uint64_t hash = 0xcbf29ce484222325ULL;  // FNV-1a
  for (const char c : channel) hash = (hash ^ static_cast<unsigned char>(c)) * 0x100000001b3ULL;
  return Random(hash ^ (seed * 0x9e3779b97f4a7c15ULL));
}

}  // namespace

void addNoise(const Signal& signal, const SensorNoise& noise, std::uint64_t seed,
              std::vector<double>& values) {
  Random random = generatorOf(signal.name, seed);
  for (double& value : values) {
    switch (signal.kind) {
      case SignalKind::position:
        if (noise.encoderStep > 0) value = std::round(value / noise.encoderStep) * noise.encoderStep;
        value += noise.encoder * random.gaussian();
        break;
      case SignalKind::gyro:
        value += noise.gyro * random.gaussian();
        break;
      case SignalKind::accelerometer:
        value += noise.accelerometer * random.gaussian();
        break;
      case SignalKind::force:
        value = std::max(0.0, value + noise.force * random.gaussian());
        break;
      default:
        break;
    }
  }
}

double noiseOf(const Signal& signal, const SensorNoise& noise) {
  switch (signal.kind) {
    case SignalKind::gyro:
      return noise.gyro;
    case SignalKind::accelerometer:
      return noise.accelerometer;
    case SignalKind::force:
      return noise.force;
    default:
      return std::hypot(noise.encoder, noise.encoderStep / std::sqrt(12.0));
  }
}

Run blankRun(const Mechanism& robot, const Excitation& program, double rateHz, bool truth) {
  const CommandTable table = playExcitation(program, robot, rateHz);
  Run run;
  run.folder = program.name;
  run.robot = robot.name;
  run.motion = program.about;
  run.freeBase = program.freeBase;
  run.groundTruth = truth && program.freeBase;
  run.rateHz = rateHz;
  if (program.freeBase) run.heading = program.heading;
  run.t = table.t;
  const std::vector<double> nothing(table.t.size(), std::numeric_limits<double>::quiet_NaN());
  const auto add = [&](ChannelKind kind, const std::string& place) {
    run.channels[channelName(kind, place)] = nothing;
  };
  for (std::size_t j = 0; j < robot.joints.size(); ++j) {
    run.channels[channelName(ChannelKind::command, robot.joints[j].name)] = table.commands[j];
    add(ChannelKind::position, robot.joints[j].name);
  }
  if (robot.hasImu)
    for (const char* axis : {"x", "y", "z"}) {
      add(ChannelKind::gyro, axis);
      add(ChannelKind::acceleration, axis);
    }
  if (!program.freeBase) return run;
  for (const auto& foot : robot.feet)
    for (const auto& sensor : foot.sensors) add(ChannelKind::force, foot.name + "." + sensor.corner);
  if (truth)
    for (const char* axis : {"x", "y", "z", "qw", "qx", "qy", "qz"}) add(ChannelKind::truth, axis);
  return run;
}

Run recordWith(const Mechanism& robot, const Excitation& program, const SimulatedRecordingOptions& options,
               const TrialPlayer& player) {
  if (program.freeBase && robot.feet.empty())
    throw std::invalid_argument(program.name + " stands on feet and " + robot.name + " has none");
  Run run = blankRun(robot, program, options.rateHz > 0 ? options.rateHz : robot.controlHz, options.truth);
  const Trial trial = trialOf(run, robot);
  const Plant plant = plantOf(robot, options.effects);
  Prediction prediction =
      player(plant, trial, drawLostCycles(plant, trial, generatorOf("lost cycles", options.seed)));
  for (std::size_t s = 0; s < trial.signals.size(); ++s) {
    std::vector<double>& values = prediction.values[s];
    if (values.empty()) continue;
    if (options.noisy) addNoise(trial.signals[s], options.noise, options.seed, values);
    run.channels[trial.signals[s].name] = std::move(values);
  }
  return run;
}

Run recordSimulated(const Mechanism& robot, const Excitation& program,
                    const SimulatedRecordingOptions& options) {
  return recordWith(
      robot, program, options,
      [&options](const Plant& plant, const Trial& trial, const std::vector<std::uint8_t>& lost) {
        ReplayOptions replayOptions;
        replayOptions.step = options.step;
        replayOptions.gearStep = std::min(replayOptions.gearStep, options.step);
        if (!lost.empty()) replayOptions.lostCycles = &lost;
        return replay(plant, trial, replayOptions);
      });
}

}  // namespace plumbline::gap
