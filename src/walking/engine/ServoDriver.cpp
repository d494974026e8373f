#include "walking/engine/ServoDriver.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace plumbline::walking {
namespace {

constexpr double accelerometerShare = 0.004;  // of one measurement, at 100 Hz
constexpr double leastForce = 1;              // on a foot that touches the ground [N]

}  // namespace

ServoDriver::ServoDriver(const Mechanism& mechanism_)
    : mechanism(mechanism_), robot(mechanism), filter(accelerometerShare), load(robot.model()) {
  if (mechanism.feet.size() != 2)
    throw std::invalid_argument("robot " + mechanism.name + " has " + std::to_string(mechanism.feet.size()) +
                                " feet; the walk needs two");
  const int left = mechanism.joints[static_cast<std::size_t>(robot.mechanismJoint(lAnkleRoll))].child;
  feet = mechanism.feet[0].link == left ? std::array<std::size_t, 2>{0, 1} : std::array<std::size_t, 2>{1, 0};
  reset();
}

void ServoDriver::reset() {
  filter.reset();
  begun = false;
  share = {0.5, 0.5};
  command_.target.assign(mechanism.joints.size(), 0);
  command_.stiffness.assign(mechanism.joints.size(), 1);
}

WalkSensors ServoDriver::sense(const ServoMeasurement& measured) {
  WalkSensors sensors;
  sensors.dt = cycle();
  sensors.angles = robot.toModel(measured.position);
  const Mat3 R_torso_sensor = rotationOfRpy(mechanism.imu.rpy);
  sensors.gyro = R_torso_sensor * measured.gyro;
  filter.update(sensors.gyro, R_torso_sensor * measured.acc, sensors.dt);
  sensors.torsoAngles = Vec2(filter.roll(), filter.pitch());
  sensors.feet.emplace();
  sensors.feet->shear = false;
  for (std::size_t i = 0; i < 2; ++i) {
    const Mechanism::Foot& foot = mechanism.feet[feet[i]];
    const std::vector<double>& forces = measured.footForce.at(feet[i]);
    double sum = 0;
    Vec3 centre = Vec3::Zero();
    for (std::size_t k = 0; k < foot.sensors.size(); ++k) {
      sum += forces.at(k);
      centre += forces[k] * foot.sensors[k].position;
    }
    if (sum < leastForce) continue;
    const Vec3& com = mechanism.links[static_cast<std::size_t>(foot.link)].com;
    sensors.feet->foot[i] = FootContact{centre / sum - com, Vec3(0, 0, sum)};
  }
  return sensors;
}

const ServoCommand& ServoDriver::command(const WalkOutput& output, const WalkParameters& p,
                                         const WalkSensors& sensors) {
  // The weight goes from foot to foot within a few cycles.
  constexpr double shiftTime = 0.03;  // [s]
  const double left = output.support == Support::both ? 0.5 : output.support == Support::left ? 1 : 0;
  const double most = sensors.dt / shiftTime;
  share[0] += std::clamp(left - share[0], -most, most);
  share[1] = 1 - share[0];
  const JointArray& torque = load.update(output.angles, sensors.torsoAngles, share, p.model.pressure());
  for (std::size_t j = 0; j < maxJoints; ++j) {
    const int index = robot.mechanismJoint(static_cast<JointId>(j));
    if (index < 0) continue;
    const Mechanism::Joint& joint = mechanism.joints[static_cast<std::size_t>(index)];
    const double kp = joint.servo.kp * std::max(0.1, output.stiffness[j]);
    double target = output.set[j] ? output.angles[j] : 0;
    if (output.set[j] && kp > 0) {
      const double rate = begun ? (output.angles[j] - last[j]) / sensors.dt : 0;
      target += p.servo.loadLead * torque[j] / kp + p.servo.rateLead * joint.servo.kd / joint.servo.kp * rate;
    }
    command_.target[static_cast<std::size_t>(index)] = std::clamp(target, joint.lower, joint.upper);
    command_.stiffness[static_cast<std::size_t>(index)] = output.stiffness[j];
  }
  last = output.angles;
  begun = true;
  return command_;
}

}  // namespace plumbline::walking
