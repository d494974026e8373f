#include "walking/engine/PositionServoAdapter.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace plumbline::walking {
namespace {

constexpr double accelerometerShare = 0.004;  // of one measurement, at 100 Hz
constexpr double leastForce = 1;              // on a foot that touches the ground [N]

}  // namespace

PositionServoAdapter::PositionServoAdapter(const Mechanism& mechanism)
    : mechanism_(mechanism), robot_(mechanism_), filter_(accelerometerShare), load_(robot_.model()) {
  if (mechanism_.feet.size() != 2)
    throw std::invalid_argument("robot " + mechanism_.name + " has " +
                                std::to_string(mechanism_.feet.size()) + " feet; the walk needs two");
  const int left = mechanism_.joints[static_cast<std::size_t>(robot_.mechanismJoint(lAnkleRoll))].child;
  feet_ =
      mechanism_.feet[0].link == left ? std::array<std::size_t, 2>{0, 1} : std::array<std::size_t, 2>{1, 0};
  reset();
}

void PositionServoAdapter::reset() {
  filter_.reset();
  begun_ = false;
  share_ = {0.5, 0.5};
  command_.target.assign(mechanism_.joints.size(), 0);
  command_.stiffness.assign(mechanism_.joints.size(), 1);
}

WalkSensors PositionServoAdapter::sense(const ServoMeasurement& measured) {
  WalkSensors sensors;
  sensors.dt = cycle();
  sensors.angles = robot_.toModel(measured.position);
  const Mat3 R_torso_sensor = rotationOfRpy(mechanism_.imu.rpy);
  sensors.gyro = R_torso_sensor * measured.gyro;
  filter_.update(sensors.gyro, R_torso_sensor * measured.acc, sensors.dt);
  sensors.torsoAngles = Vec2(filter_.roll(), filter_.pitch());
  sensors.feet.emplace();
  sensors.feet->shear = false;
  for (std::size_t i = 0; i < 2; ++i) {
    const Mechanism::Foot& foot = mechanism_.feet[feet_[i]];
    const std::vector<double>& forces = measured.footForce.at(feet_[i]);
    double sum = 0;
    Vec3 centre = Vec3::Zero();
    for (std::size_t k = 0; k < foot.sensors.size(); ++k) {
      sum += forces.at(k);
      centre += forces[k] * foot.sensors[k].position;
    }
    if (sum < leastForce) continue;
    const Vec3& com = mechanism_.links[static_cast<std::size_t>(foot.link)].com;
    sensors.feet->foot[i] = FootContact{centre / sum - com, Vec3(0, 0, sum)};
  }
  return sensors;
}

const ServoCommand& PositionServoAdapter::command(const WalkOutput& output, const WalkParameters& p,
                                                  const WalkSensors& sensors) {
  // The weight goes from foot to foot within a few cycles.
  constexpr double shiftTime = 0.03;  // [s]
  const double left = output.support == Support::both ? 0.5 : output.support == Support::left ? 1 : 0;
  const double most = sensors.dt / shiftTime;
  share_[0] += std::clamp(left - share_[0], -most, most);
  share_[1] = 1 - share_[0];
  const JointArray& torque = load_.update(output.angles, sensors.torsoAngles, share_, p.model.pressure());
  for (std::size_t j = 0; j < maxJoints; ++j) {
    const int index = robot_.mechanismJoint(static_cast<JointId>(j));
    if (index < 0) continue;
    const Mechanism::Joint& joint = mechanism_.joints[static_cast<std::size_t>(index)];
    const double kp = joint.servo.kp * std::max(0.1, output.stiffness[j]);
    double target = output.set[j] ? output.angles[j] : 0;
    if (output.set[j] && kp > 0) {
      const double rate = begun_ ? (output.angles[j] - last_[j]) / sensors.dt : 0;
      target += p.servo.loadLead * torque[j] / kp +
                p.servo.rateLead * (joint.servo.kd + joint.damping) / joint.servo.kp * rate;
    }
    command_.target[static_cast<std::size_t>(index)] = std::clamp(target, joint.lower, joint.upper);
    command_.stiffness[static_cast<std::size_t>(index)] = output.stiffness[j];
  }
  last_ = output.angles;
  begun_ = true;
  return command_;
}

}  // namespace plumbline::walking
