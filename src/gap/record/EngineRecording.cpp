#include "gap/record/EngineRecording.h"

#include <algorithm>
#include <cmath>
#include <memory>
#include <stdexcept>

#include "framework/ConfigurationError.h"
#include "framework/StopSignal.h"
#include "gap/replay/TrialOf.h"
#include "gap/replay/TruePose.h"

namespace plumbline::gap {

namespace {

constexpr double settle = 1;       // [s]
constexpr double finest = 0.0005;  // [s]: what its steps then still make wrong is within an encoder's noise
constexpr double hung = 10;        // [m]: far from the ground

void check(const std::string& engine, const Plant& plant) {
  if (plant.forces.size() > 1)
    throw ConfigurationError("engine " + engine +
                             " has one external_force at a time; --engine own has several");
}

class Recorder {
public:
  Recorder(const std::string& engine, const Plant& plant_, const Trial& trial_,
           const std::vector<std::uint8_t>& lost_, double slice_, OutsideEffects* outside_)
      : plant(plant_),
        trial(trial_),
        lost(lost_),
        slice(slice_),
        outside(outside_),
        ground(rotationOfGround(plant_.ground)),
        simulated(simulation::RobotSimulations::make(engine, engineMechanism(plant_, 1 / slice_),
                                                     engineOptions(plant_, !trial_.freeBase, slice_))),
        world(*simulated) {}

  Prediction play() {
    Prediction prediction;
    prediction.values.assign(trial.signals.size(), std::vector<double>(trial.cycles(), NAN));
    std::vector<double> start, first;
    for (std::size_t j = 0; j < plant.joints.size(); ++j) {
      first.push_back(commandAt(j, trial.time[0]));
      start.push_back(first[j] + plant.joints[j].offset);
    }
    if (trial.freeBase)
      world.restart(start, trial.heading);
    else
      world.restart(translation(0, 0, hung), start);
    if (outside) outside->start(first);
    for (int i = 0; i < static_cast<int>(settle / slice); ++i) advance(trial.time[0] - settle, first);
    for (const ExternalForce& force : plant.forces)
      world.push(ground.transpose() * force.force, 1e6, force.link);
    history.clear();
    remember();
    // The latest slice stands at time[0]; readings of a cycle are those of its slice.
    double now = trial.time[0];
    for (std::size_t k = 0; k < trial.cycles(); ++k) {
      while (now < trial.time[k] - slice / 2) {
        std::vector<double> targets;
        for (std::size_t j = 0; j < plant.joints.size(); ++j) targets.push_back(meanCommand(j, now));
        advance(now, targets);
        now += slice;
        remember();
      }
      sense(k, prediction);
      prediction.fell = prediction.fell || (trial.freeBase && world.base().pose.linear()(2, 2) < 0.5);
    }
    return prediction;
  }

private:
  void advance(double now, std::vector<double> targets) {
    StopSignal::throwIfCaught();
    if (outside) outside->act(now, slice, world, targets);
    world.command(targets);
    world.step();
  }

  /// What is in force at a joint at this time: the newest command that has arrived by then.
  double commandAt(std::size_t joint, double time) const {
    const std::size_t k = cycleAt(joint, time);
    return trial.command[joint].empty() ? 0 : trial.command[joint][k];
  }

  std::size_t cycleAt(std::size_t joint, double time) const {
    const double when = time - trial.commandAt[joint] - plant.joints[joint].commandDelay + 1e-9;
    auto k = static_cast<std::ptrdiff_t>(std::upper_bound(trial.time.begin(), trial.time.end(), when) -
                                         trial.time.begin()) -
             1;
    while (k > 0 && !lost.empty() && lost[static_cast<std::size_t>(k)]) --k;
    return static_cast<std::size_t>(std::max<std::ptrdiff_t>(0, k));
  }

  /// Mean over the slice that begins now: a command that arrives within it counts by its share.
  double meanCommand(std::size_t joint, double now) const {
    const double before = commandAt(joint, now), after = commandAt(joint, now + slice);
    if (before == after) return before;
    const double arrival =
        trial.time[cycleAt(joint, now + slice)] + trial.commandAt[joint] + plant.joints[joint].commandDelay;
    const double share = std::clamp((now + slice - arrival) / slice, 0.0, 1.0);
    return before + share * (after - before);
  }

  struct Inertial {
    Vec3 gyro, acc;
  };

  void remember() {
    const simulation::ServoReadings& readings = world.readings();
    history.push_back({readings.gyro, readings.acc});
  }

  void sense(std::size_t k, Prediction& prediction) const {
    const simulation::ServoReadings& readings = world.readings();
    // Between two slices what lies between.
    const double late = std::min(plant.imu.delay / slice, static_cast<double>(history.size() - 1));
    const auto whole = static_cast<std::size_t>(late);
    const double share = late - static_cast<double>(whole);
    const Inertial& newer = history[history.size() - 1 - whole];
    const Inertial& older = history[history.size() - 1 - std::min(whole + 1, history.size() - 1)];
    const Vec3 gyro = (1 - share) * newer.gyro + share * older.gyro,
               acc = (1 - share) * newer.acc + share * older.acc;
    const Mat3 toSensor = plant.imu.R_true_sensor.transpose();
    const Pose3 base = Pose3(ground) * world.base().pose;
    const std::array<double, 7> pose = poseValues(base);
    for (std::size_t s = 0; s < trial.signals.size(); ++s) {
      const Signal& signal = trial.signals[s];
      double& value = prediction.values[s][k];
      switch (signal.kind) {
        case SignalKind::position:
          // Drives step by the leapfrog: their positions are half a step ahead of their speeds (ServoDrive).
          value = world.encoder(signal.joint) - slice / 2 * world.encoderSpeed(signal.joint);
          break;
        case SignalKind::velocity:
          value = world.encoderSpeed(signal.joint);
          break;
        case SignalKind::gyro:
          value = (toSensor * gyro + plant.imu.gyroBias)[signal.axis];
          break;
        case SignalKind::accelerometer:
          value = (toSensor * acc)[signal.axis] + (outside ? outside->accBias()[signal.axis] : 0);
          break;
        case SignalKind::force:
          value =
              plant.footGain[static_cast<std::size_t>(signal.place)] *
              readings
                  .footForce[static_cast<std::size_t>(signal.place)][static_cast<std::size_t>(signal.axis)];
          break;
        case SignalKind::truth:
          value = pose[static_cast<std::size_t>(signal.axis)];
          break;
        default:
          break;
      }
    }
  }

  const Plant& plant;
  const Trial& trial;
  const std::vector<std::uint8_t>& lost;
  const double slice;  ///< commands are averaged over so much [s]
  OutsideEffects* const outside;
  const Mat3 ground;  ///< R_world_ground; the simulated world is the ground's
  const std::unique_ptr<simulation::RobotSimulation> simulated;
  simulation::RobotSimulation& world;
  std::vector<Inertial> history;
};

}  // namespace

Mechanism engineMechanism(const Plant& plant, double controlHz) {
  Mechanism robot = plant.mechanism;
  // Else the engine would let one servo carry both.
  for (Mechanism::Joint& joint : robot.joints) joint.driver = -1;
  robot.controlHz = controlHz;
  robot.gravity = rotationOfGround(plant.ground).transpose() * robot.gravity;
  return robot;
}

simulation::RobotSimulationOptions engineOptions(const Plant& plant, bool fixedBase, double step) {
  simulation::RobotSimulationOptions config;
  config.fixedBase = fixedBase;
  config.stepSeconds = step;
  config.groundFriction = plant.ground.friction;
  config.groundStiffness = 1 / plant.ground.compliance;
  config.drives = plant.joints;
  return config;
}

Run recordInEngine(const std::string& engine, const Mechanism& robot, const Excitation& program,
                   const SimulatedRecordingOptions& options, OutsideEffects* outside) {
  check(engine, plantOf(robot, options.effects));
  return recordWith(
      robot, program, options,
      [&](const Plant& plant, const Trial& trial, const std::vector<std::uint8_t>& lost) {
        return Recorder(engine, plant, trial, lost, std::min(finest, options.step), outside).play();
      });
}

}  // namespace plumbline::gap
