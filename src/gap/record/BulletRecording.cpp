#include "gap/record/BulletRecording.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "framework/ConfigurationError.h"
#include "gap/replay/TrialOf.h"
#include "gap/replay/TruePose.h"
#include "simulation/servo/ServoWorld.h"

namespace plumbline::gap {

namespace {

constexpr double slice = 0.001;  // [s]: commands arrive and readings are taken to so much
constexpr double settle = 1;     // [s]
constexpr double hung = 10;      // [m]: far from the ground

void check(const Explanation& effects) {
  std::string known;
  for (const std::string_view id : bulletEffects()) known += (known.empty() ? "" : ", ") + std::string(id);
  int forces = 0;
  for (const Cause& cause : effects) {
    if (std::ranges::find(bulletEffects(), cause.effect->id) == bulletEffects().end())
      throw ConfigurationError("engine bullet has no " + std::string(cause.effect->id) + "; it has " + known +
                               "; --engine own has all");
    if (cause.effect->id == "external_force" && ++forces > 1)
      throw ConfigurationError("engine bullet has one external_force at a time; --engine own has several");
  }
}

class Recorder {
public:
  Recorder(const Plant& plant_, const Trial& trial_, const std::vector<std::uint8_t>& lost_)
      : plant(plant_),
        trial(trial_),
        lost(lost_),
        ground(rotationOfGround(plant_.ground)),
        world(bulletMechanism(plant_, 1 / slice), bulletWorld(plant_, !trial_.freeBase)) {}

  Prediction play() {
    Prediction prediction;
    prediction.values.assign(trial.signals.size(), std::vector<double>(trial.cycles(), NAN));
    std::vector<double> start;
    for (std::size_t j = 0; j < plant.joints.size(); ++j)
      start.push_back(commandAt(j, trial.time[0]) + plant.joints[j].offset);
    if (trial.freeBase)
      world.restart(start, trial.heading);
    else
      world.restart(translation(0, 0, hung), start);
    for (int i = 0; i < static_cast<int>(settle / slice); ++i) world.step();
    for (const ExternalForce& force : plant.forces)
      world.push(ground.transpose() * force.force, 1e6, force.link);
    // The latest slice stands at time[0]; readings of a cycle are those of its slice.
    double now = trial.time[0];
    for (std::size_t k = 0; k < trial.cycles(); ++k) {
      while (now < trial.time[k] - slice / 2) {
        std::vector<double> targets;
        for (std::size_t j = 0; j < plant.joints.size(); ++j)
          targets.push_back(commandAt(j, now) + plant.joints[j].offset);
        world.command(targets);
        world.step();
        now += slice;
        remember();
      }
      if (history.empty()) remember();
      sense(k, prediction);
      prediction.fell = prediction.fell || (trial.freeBase && world.base().pose.linear()(2, 2) < 0.5);
    }
    return prediction;
  }

private:
  /// What is in force at a joint at this time: the newest command that has arrived by then.
  double commandAt(std::size_t joint, double time) const {
    const auto& command = trial.command[joint];
    if (command.empty()) return 0;
    const double when = time - trial.commandAt[joint] - plant.joints[joint].commandDelay + slice / 4;
    auto k = static_cast<std::ptrdiff_t>(std::upper_bound(trial.time.begin(), trial.time.end(), when) -
                                         trial.time.begin()) -
             1;
    while (k > 0 && !lost.empty() && lost[static_cast<std::size_t>(k)]) --k;
    return command[static_cast<std::size_t>(std::max<std::ptrdiff_t>(0, k))];
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
    const auto late = static_cast<std::size_t>(std::lround(plant.imu.delay / slice));
    const Inertial& imu = history[history.size() - 1 - std::min(late, history.size() - 1)];
    const Mat3 toSensor = plant.imu.R_true_sensor.transpose();
    const Pose3 base = Pose3(ground) * world.base().pose;
    const std::array<double, 7> pose = poseValues(base);
    for (std::size_t s = 0; s < trial.signals.size(); ++s) {
      const Signal& signal = trial.signals[s];
      double& value = prediction.values[s][k];
      const auto joint = static_cast<std::size_t>(std::max(0, signal.joint));
      switch (signal.kind) {
        case SignalKind::position:
          value = readings.position[joint] - plant.joints[joint].offset;
          break;
        case SignalKind::velocity:
          value = readings.velocity[joint];
          break;
        case SignalKind::gyro:
          value = (toSensor * imu.gyro + plant.imu.gyroBias)[signal.axis];
          break;
        case SignalKind::accelerometer:
          value = (toSensor * imu.acc)[signal.axis];
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
  const Mat3 ground;  ///< R_world_ground; the simulated world is the ground's
  simulation::ServoWorld world;
  std::vector<Inertial> history;
};

}  // namespace

Mechanism bulletMechanism(const Plant& plant, double controlHz) {
  Mechanism robot = plant.mechanism;
  for (std::size_t j = 0; j < robot.joints.size(); ++j) {
    Mechanism::Joint& joint = robot.joints[j];
    const JointPlant& drive = plant.joints[j];
    joint.servo = drive.servo;
    joint.servo.vin *= drive.supplyFactor;
    joint.maxTorque = drive.maxTorque * drive.torqueFactor;
    joint.maxSpeed = drive.maxSpeed;
    // Else ServoWorld would let one servo carry both.
    joint.driver = -1;
  }
  robot.controlHz = controlHz;
  robot.gravity = rotationOfGround(plant.ground).transpose() * robot.gravity;
  return robot;
}

simulation::ServoWorldConfig bulletWorld(const Plant& plant, bool fixedBase) {
  simulation::ServoWorldConfig config;
  config.fixedBase = fixedBase;
  config.stepSeconds = slice;
  config.groundFriction = plant.ground.friction;
  config.groundStiffness = 1 / plant.ground.compliance;
  return config;
}

const std::vector<std::string_view>& bulletEffects() {
  static const std::vector<std::string_view> ids = {
      "command_delay", "command_dropout", "servo_gain",    "servo_damping",     "torque_limit",
      "speed_limit",   "supply_voltage",  "rotor_inertia", "joint_offset",      "link_mass",
      "com_offset",    "link_length",     "gyro_bias",     "imu_misalignment",  "imu_delay",
      "fsr_gain",      "ground_friction", "ground_slope",  "ground_compliance", "external_force"};
  return ids;
}

const std::vector<std::string_view>& walkEffects() {
  static const std::vector<std::string_view> ids = {"servo_gain",      "servo_damping",  "torque_limit",
                                                    "speed_limit",     "supply_voltage", "rotor_inertia",
                                                    "link_mass",       "com_offset",     "link_length",
                                                    "ground_friction", "ground_slope",   "ground_compliance"};
  return ids;
}

Run recordBullet(const Mechanism& robot, const Excitation& program,
                 const SimulatedRecordingOptions& options) {
  check(options.effects);
  return recordWith(robot, program, options,
                    [](const Plant& plant, const Trial& trial, const std::vector<std::uint8_t>& lost) {
                      return Recorder(plant, trial, lost).play();
                    });
}

}  // namespace plumbline::gap
