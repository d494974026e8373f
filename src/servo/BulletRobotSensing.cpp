// What a BulletRobot's sensors read.
#include "math/Index.h"
#include "servo/BulletRobot.h"
#include "servo/FootSensors.h"

namespace plumbline::servo {

double BulletRobot::encoder(int joint) const {
  return drives_.at(at(joint)).measured(motorSide(joint), linkSide(joint));
}

double BulletRobot::encoderSpeed(int joint) const {
  return drives_.at(at(joint)).drive().linkEncoder ? linkSide(joint).speed : motorSide(joint).speed;
}

void BulletRobot::senseImu() {
  const simulation::BodyState& carrier = link(mechanism_.imu.link);
  imuVelocity_ = carrier.linearVelocity +
                 carrier.angularVelocity.cross(carrier.pose.linear() * mechanism_.imu.accelerometer);
  readings_.gyro =
      (carrier.pose.linear() * rotationOfRpy(mechanism_.imu.rpy)).transpose() * carrier.angularVelocity;
}

void BulletRobot::sense() {
  readings_.time = static_cast<double>(cycles_) * stepsPerCycle_ * h_;
  readings_.position.resize(drives_.size());
  readings_.velocity.resize(drives_.size());
  readings_.torque.resize(drives_.size());
  for (int i = 0; i < mechanism_.numJoints(); ++i) {
    readings_.position[at(i)] = linkSide(i).position;
    readings_.velocity[at(i)] = linkSide(i).speed;
    readings_.torque[at(i)] = torqueSum_[at(i)] / stepsPerCycle_;
  }
  readings_.footForce.clear();
  for (std::size_t f = 0; f < mechanism_.feet.size(); ++f)
    readings_.footForce.push_back(footForces(static_cast<int>(f)));
}

std::vector<double> BulletRobot::footForces(int index) const {
  const Mechanism::Foot& foot = mechanism_.feet[at(index)];
  const Mat3 toFoot = link(foot.link).pose.linear().transpose();
  double whole = 0;
  Vec2 centre = Vec2::Zero();
  for (const Point& point : points_)
    if (point.foot == index && !point.force.isZero(0)) {
      const double normal = (toFoot * point.force).z();
      whole += normal;
      centre += normal * point.local.head<2>();
    }
  if (whole > 0) centre /= whole;
  return footSensorForces(foot, whole, centre);
}

}  // namespace plumbline::servo
