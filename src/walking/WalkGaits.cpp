#include "walking/WalkGaits.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace plumbline::walking {

WalkParameters WalkGaits::at(const Vec2& velocity, double turn) const {
  std::array<double, numCorners> share{
      std::max(0.0, velocity.x() / base.maxForward), std::max(0.0, -velocity.x() / base.maxBackward),
      std::abs(velocity.y()) / base.maxSideways, std::abs(turn) / base.maxTurn};
  for (double& s : share) s = std::max(0.0, s - base.blendStart) / (1 - base.blendStart);
  double sum = 0;
  for (const double s : share) sum += s;
  if (sum > 1)
    for (double& s : share) s /= sum;
  WalkParameters blended = base;
  for (const WalkParameterInfo& info : walkParameterTable()) {
    if (!info.blends) continue;
    double& value = blended.*info.value;
    const double spot = value;
    for (std::size_t i = 0; i < numCorners; ++i) value += share[i] * (corner[i].*info.value - spot);
  }
  return blended;
}

void WalkGaits::check() const {
  base.check();
  for (std::size_t i = 0; i < numCorners; ++i) {
    try {
      corner[i].check();
    } catch (const std::invalid_argument& error) {
      throw std::invalid_argument(std::string(cornerNames[i]) + ": " + error.what());
    }
  }
}

}  // namespace plumbline::walking
