#include "walking/engine/PositionServoAdapter.h"

#include "walking/estimation/SoleContact.h"

namespace plumbline::walking {
namespace {

constexpr double accelerometerShare = 0.004;  // of one measurement, at 100 Hz

}  // namespace

PositionServoAdapter::PositionServoAdapter(const Mechanism& mechanism)
    : lead_(mechanism), feet_(twoFeet(lead_.mechanism(), lead_.humanoid())), filter_(accelerometerShare) {}

void PositionServoAdapter::reset() {
  filter_.reset();
  lead_.reset();
}

WalkSensors PositionServoAdapter::sense(const ServoMeasurement& measured) {
  WalkSensors sensors;
  sensors.dt = cycle();
  sensors.angles = lead_.humanoid().toModel(measured.position);
  const Mechanism& robot = lead_.mechanism();
  const Mat3 R_torso_sensor = rotationOfRpy(robot.imu.rpy);
  sensors.gyro = R_torso_sensor * measured.gyro;
  filter_.update(sensors.gyro, R_torso_sensor * measured.acc, sensors.dt);
  sensors.torsoAngles = Vec2(filter_.roll(), filter_.pitch());
  sensors.feet.emplace();
  sensors.feet->shear = false;
  for (std::size_t i = 0; i < 2; ++i)
    sensors.feet->foot[i] = soleContact(robot, robot.feet[feet_[i]], measured.footForce.at(feet_[i]));
  return sensors;
}

const ServoCommand& PositionServoAdapter::command(const WalkOutput& output, const WalkParameters& p,
                                                  const WalkSensors& sensors) {
  return lead_.command({output.angles, output.set, output.stiffness, output.leftShare()}, p,
                       sensors.torsoAngles, sensors.dt);
}

}  // namespace plumbline::walking
