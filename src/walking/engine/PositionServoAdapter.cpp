#include "walking/engine/PositionServoAdapter.h"

#include <stdexcept>

#include "walking/estimation/SoleContact.h"

namespace plumbline::walking {
namespace {

constexpr double accelerometerShare = 0.004;  // of one measurement, at 100 Hz

}  // namespace

PositionServoAdapter::PositionServoAdapter(const Mechanism& mechanism)
    : mechanism_(mechanism), robot_(mechanism_), filter_(accelerometerShare), lead_(mechanism_, robot_) {
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
  lead_.reset();
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
  for (std::size_t i = 0; i < 2; ++i)
    sensors.feet->foot[i] =
        soleContact(mechanism_, mechanism_.feet[feet_[i]], measured.footForce.at(feet_[i]));
  return sensors;
}

const ServoCommand& PositionServoAdapter::command(const WalkOutput& output, const WalkParameters& p,
                                                  const WalkSensors& sensors) {
  return lead_.command({output.angles, output.set, output.stiffness, output.leftShare()}, p,
                       sensors.torsoAngles, sensors.dt);
}

}  // namespace plumbline::walking
