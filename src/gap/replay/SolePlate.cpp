#include "gap/replay/SolePlate.h"

#include <Eigen/Cholesky>
#include <algorithm>

namespace plumbline::gap {

std::array<Vec3, 4> soleCorners(const Mechanism::Foot& foot) {
  std::array<Vec3, 4> corners;
  for (std::size_t i = 0; i < corners.size(); ++i)
    corners[i] =
        foot.soleCentre + Vec3(i < 2 ? 0.5 : -0.5, i % 2 ? -0.5 : 0.5, -0.5).cwiseProduct(foot.soleSize);
  return corners;
}

std::vector<double> plateForces(const Mechanism::Foot& foot, double normal, const Vec2& centre) {
  std::vector<double> loads(foot.sensors.size(), 0.0);
  if (!(normal > 0) || loads.empty()) return loads;
  constexpr double metre = 0.05;     // makes the three unknowns alike
  constexpr double softness = 1e-4;  // a plate that balances on two springs still has a place
  const auto row = [&](const Mechanism::ForceSensor& s) {
    return Vec3(1, s.position.x() / metre, s.position.y() / metre);
  };
  const Vec3 wanted = normal * Vec3(1, centre.x() / metre, centre.y() / metre);
  // Newton on the plate's height and tilt: only springs that are pressed count.
  Vec3 plane(normal / static_cast<double>(loads.size()), 0, 0);
  for (int i = 0; i < 60; ++i) {
    Vec3 missing = wanted - softness * plane;
    Mat3 slope = softness * Mat3::Identity();
    for (const Mechanism::ForceSensor& sensor : foot.sensors) {
      const Vec3 r = row(sensor);
      const double load = plane.dot(r);
      if (load <= 0) continue;
      missing -= load * r;
      slope += r * r.transpose();
    }
    if (missing.norm() < 1e-6) break;
    plane += (i < 8 ? 1.0 : 0.5) * slope.ldlt().solve(missing);
  }
  double sum = 0;
  for (std::size_t s = 0; s < loads.size(); ++s) {
    loads[s] = std::max(0.0, plane.dot(row(foot.sensors[s])));
    sum += loads[s];
  }
  for (double& load : loads) load *= sum > 0 ? normal / sum : 0;
  return loads;
}

}  // namespace plumbline::gap
