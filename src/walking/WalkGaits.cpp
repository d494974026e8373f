#include "walking/WalkGaits.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace plumbline::walking {

WalkParameters WalkGaits::at(const Vec2& velocity, double turn, double recovering) const {
  // What may be mixed is walked with the base.
  const auto beyond = [](double speed, double mix, double full) {
    const double from = mix > 0 ? std::min(mix, full) : 0;
    return from < full ? std::clamp((speed - from) / (full - from), 0.0, 1.0) : 0.0;
  };
  std::array<double, numCorners> share{beyond(velocity.x(), base.mixForward, base.maxForward),
                                       beyond(-velocity.x(), base.mixBackward, base.maxBackward),
                                       beyond(std::abs(velocity.y()), base.mixSideways, base.maxSideways),
                                       beyond(std::abs(turn), base.mixTurn, base.maxTurn)};
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
  if (recovering > 0)
    for (const auto& [info, wanted] : recovery) {
      double& value = blended.*info->value;
      value += recovering * (wanted - value);
    }
  return blended;
}

void WalkGaits::check() const {
  base.check();
  const auto checkPart = [](const std::string& name, const WalkParameters& part) {
    try {
      part.check();
    } catch (const std::invalid_argument& error) {
      throw std::invalid_argument(name + ": " + error.what());
    }
  };
  for (std::size_t i = 0; i < numCorners; ++i) checkPart(cornerNames[i], corner[i]);
  checkPart("recovery", at(Vec2::Zero(), 0, 1));
}

}  // namespace plumbline::walking
