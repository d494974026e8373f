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
  Recorder(const std::string& engine, const Plant& plant, const Trial& trial,
           const std::vector<std::uint8_t>& lost, double slice, OutsideEffects* outside)
      : plant_(plant),
        trial_(trial),
        lost_(lost),
        slice_(slice),
        outside_(outside),
        ground_(rotationOfGround(plant.ground)),
        simulated_(servo::RobotSimulations::make(engine, engineMechanism(plant, 1 / slice),
                                                 engineOptions(plant, !trial.freeBase, slice))),
        world_(*simulated_) {}

  Prediction play() {
    Prediction prediction;
    prediction.values.assign(trial_.signals.size(), std::vector<double>(trial_.cycles(), NAN));
    std::vector<double> start, first;
    for (std::size_t j = 0; j < plant_.joints.size(); ++j) {
      first.push_back(commandAt(j, trial_.time[0]));
      start.push_back(first[j] + plant_.joints[j].offset);
    }
    if (trial_.freeBase)
      world_.restart(start, trial_.heading);
    else
      world_.restart(translation(0, 0, hung), start);
    if (outside_) outside_->start(first);
    for (int i = 0; i < static_cast<int>(settle / slice_); ++i) advance(trial_.time[0] - settle, first);
    for (const ExternalForce& force : plant_.forces)
      world_.push(ground_.transpose() * force.force, 1e6, force.link);
    history_.clear();
    remember();
    // The latest slice is at time[0]; readings of a cycle are those of its slice.
    double now = trial_.time[0];
    for (std::size_t k = 0; k < trial_.cycles(); ++k) {
      while (now < trial_.time[k] - slice_ / 2) {
        std::vector<double> targets;
        for (std::size_t j = 0; j < plant_.joints.size(); ++j) targets.push_back(meanCommand(j, now));
        advance(now, targets);
        now += slice_;
        remember();
      }
      sense(k, prediction);
      prediction.fell = prediction.fell || (trial_.freeBase && world_.base().pose.linear()(2, 2) < 0.5);
    }
    return prediction;
  }

private:
  void advance(double now, std::vector<double> targets) {
    StopSignal::throwIfCaught();
    if (outside_) outside_->act(now, slice_, world_, targets);
    world_.command(targets);
    world_.step();
  }

  /// What is in force at a joint at this time: the newest command that has arrived by then.
  double commandAt(std::size_t joint, double time) const {
    const std::size_t k = cycleAt(joint, time);
    return trial_.command[joint].empty() ? 0 : trial_.command[joint][k];
  }

  std::size_t cycleAt(std::size_t joint, double time) const {
    const double when = time - trial_.commandAt[joint] - plant_.joints[joint].commandDelay + 1e-9;
    auto k = static_cast<std::ptrdiff_t>(std::upper_bound(trial_.time.begin(), trial_.time.end(), when) -
                                         trial_.time.begin()) -
             1;
    while (k > 0 && !lost_.empty() && lost_[static_cast<std::size_t>(k)]) --k;
    return static_cast<std::size_t>(std::max<std::ptrdiff_t>(0, k));
  }

  /// Mean over the slice that begins now: a command that arrives within it counts by its share.
  double meanCommand(std::size_t joint, double now) const {
    const double before = commandAt(joint, now), after = commandAt(joint, now + slice_);
    if (before == after) return before;
    const double arrival = trial_.time[cycleAt(joint, now + slice_)] + trial_.commandAt[joint] +
                           plant_.joints[joint].commandDelay;
    const double share = std::clamp((now + slice_ - arrival) / slice_, 0.0, 1.0);
    return before + share * (after - before);
  }

  struct Inertial {
    Vec3 gyro, acc;
  };

  void remember() {
    const servo::ServoReadings& readings = world_.readings();
    history_.push_back({readings.gyro, readings.acc});
  }

  void sense(std::size_t k, Prediction& prediction) const {
    const servo::ServoReadings& readings = world_.readings();
    // Between two slices what lies between.
    const double late = std::min(plant_.imu.delay / slice_, static_cast<double>(history_.size() - 1));
    const auto whole = static_cast<std::size_t>(late);
    const double share = late - static_cast<double>(whole);
    const Inertial& newer = history_[history_.size() - 1 - whole];
    const Inertial& older = history_[history_.size() - 1 - std::min(whole + 1, history_.size() - 1)];
    const Vec3 gyro = (1 - share) * newer.gyro + share * older.gyro,
               acc = (1 - share) * newer.acc + share * older.acc;
    const Mat3 toSensor = plant_.imu.R_true_sensor.transpose();
    const Pose3 base = Pose3(ground_) * world_.base().pose;
    const std::array<double, 7> pose = poseValues(base);
    for (std::size_t s = 0; s < trial_.signals.size(); ++s) {
      const Signal& signal = trial_.signals[s];
      double& value = prediction.values[s][k];
      switch (signal.kind) {
        case SignalKind::position:
          // Drives step by the leapfrog: their positions are half a step ahead of their speeds (ServoDrive).
          value = world_.encoder(signal.joint) - slice_ / 2 * world_.encoderSpeed(signal.joint);
          break;
        case SignalKind::velocity:
          value = world_.encoderSpeed(signal.joint);
          break;
        case SignalKind::gyro:
          value = (toSensor * gyro + plant_.imu.gyroBias)[signal.axis];
          break;
        case SignalKind::accelerometer:
          value = (toSensor * acc)[signal.axis] + (outside_ ? outside_->accBias()[signal.axis] : 0);
          break;
        case SignalKind::force:
          value =
              plant_.footGain[static_cast<std::size_t>(signal.place)] *
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

  const Plant& plant_;
  const Trial& trial_;
  const std::vector<std::uint8_t>& lost_;
  const double slice_;  ///< commands are averaged over so much [s]
  OutsideEffects* const outside_;
  const Mat3 ground_;  ///< R_world_ground; the simulated world is the ground's
  const std::unique_ptr<servo::RobotSimulation> simulated_;
  servo::RobotSimulation& world_;
  std::vector<Inertial> history_;
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

servo::RobotSimulationOptions engineOptions(const Plant& plant, bool fixedBase, double step) {
  servo::RobotSimulationOptions config;
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
