#include "servo/FootSensors.h"

#include <Eigen/LU>
#include <algorithm>

namespace plumbline::servo {

std::vector<double> footSensorForces(const Mechanism::Foot& foot, double normal, const Vec2& centre) {
  std::vector<double> shares(foot.sensors.size(), 0);
  if (!(normal > 0) || shares.empty()) return shares;
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
  for (double& share : shares) share *= sum > 0 ? normal / sum : 0;
  return shares;
}

}  // namespace plumbline::servo
