#include "modules/modeling/ball/TeamBall.h"

#include <algorithm>
#include <cmath>

#include "tactics/RollingBall.h"

namespace plumbline {
namespace {
constexpr double agreement = 3;  ///< [standard deviations]
}  // namespace

std::optional<HeardBall> combineBalls(const std::vector<HeardBall>& heard) {
  if (heard.empty()) return std::nullopt;
  const HeardBall& best = *std::ranges::min_element(heard, {}, &HeardBall::deviation);
  HeardBall sum;
  sum.age = best.age;
  double weights = 0;
  for (const HeardBall& ball : heard) {
    const double apart = (ball.position - best.position).norm();
    if (apart > agreement * std::hypot(ball.deviation, best.deviation)) continue;
    const double weight = 1 / (ball.deviation * ball.deviation);
    sum.position += weight * ball.position;
    weights += weight;
    sum.age = std::min(sum.age, ball.age);
  }
  sum.position /= weights;
  const double keep = std::exp(-best.age / ballRollingSeconds);
  sum.velocity = keep * best.velocity;
  sum.deviation = 1 / std::sqrt(weights);
  return sum;
}

}  // namespace plumbline
