// What a ServoWorld's sensors read.
#include <Eigen/LU>
#include <algorithm>

#include "math/Index.h"
#include "simulation/servo/ServoWorld.h"

namespace plumbline::simulation {

double ServoWorld::encoder(int joint) const {
  return drives.at(at(joint)).measured(motorSide(joint), linkSide(joint));
}

double ServoWorld::encoderSpeed(int joint) const {
  return drives.at(at(joint)).drive().linkEncoder ? linkSide(joint).speed : motorSide(joint).speed;
}

void ServoWorld::senseImu() {
  const BodyState& carrier = link(mechanism_.imu.link);
  imuVelocity = carrier.linearVelocity +
                carrier.angularVelocity.cross(carrier.pose.linear() * mechanism_.imu.accelerometer);
  readings_.gyro =
      (carrier.pose.linear() * rotationOfRpy(mechanism_.imu.rpy)).transpose() * carrier.angularVelocity;
}

void ServoWorld::sense() {
  readings_.time = static_cast<double>(cycles) * stepsPerCycle * h;
  readings_.position.resize(drives.size());
  readings_.velocity.resize(drives.size());
  readings_.torque.resize(drives.size());
  for (int i = 0; i < mechanism_.numJoints(); ++i) {
    readings_.position[at(i)] = linkSide(i).position;
    readings_.velocity[at(i)] = linkSide(i).speed;
    readings_.torque[at(i)] = torqueSum[at(i)] / stepsPerCycle;
  }
  readings_.footForce.clear();
  for (std::size_t f = 0; f < mechanism_.feet.size(); ++f)
    readings_.footForce.push_back(footForces(static_cast<int>(f)));
}

/// The sole's force along its normal, shared by the sensors as a plane over them with the same centre of
/// pressure would; no sensor pulls.
std::vector<double> ServoWorld::footForces(int index) const {
  const Mechanism::Foot& foot = mechanism_.feet[at(index)];
  const Mat3 toFoot = link(foot.link).pose.linear().transpose();
  double whole = 0;
  Vec2 centre = Vec2::Zero();
  for (const Point& point : points)
    if (point.foot == index && !point.force.isZero(0)) {
      const double normal = (toFoot * point.force).z();
      whole += normal;
      centre += normal * point.local.head<2>();
    }
  std::vector<double> shares(foot.sensors.size(), 0);
  if (!(whole > 0) || shares.empty()) return shares;
  centre /= whole;
  Mat3 moments = 1e-9 * Mat3::Identity();
  for (const Mechanism::ForceSensor& sensor : foot.sensors) {
    const Vec3 m(1, sensor.position.x(), sensor.position.y());
    moments += m * m.transpose();
  }
  const Vec3 plane = moments.inverse() * Vec3(1, centre.x(), centre.y());
  double sum = 0;
  for (std::size_t i = 0; i < shares.size(); ++i) {
    const Vec3& p = foot.sensors[i].position;
    shares[i] = std::max(0.0, plane.dot(Vec3(1, p.x(), p.y())));
    sum += shares[i];
  }
  for (double& share : shares) share *= sum > 0 ? whole / sum : 0;
  return shares;
}

}  // namespace plumbline::simulation
