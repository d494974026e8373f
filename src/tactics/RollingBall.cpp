#include "tactics/RollingBall.h"

#include <algorithm>
#include <cmath>

namespace plumbline {
namespace {

constexpr double slowest = 0.3;  ///< a slower ball counts as still: noise makes one seem to move [m/s]
constexpr double latest = 4;     ///< after that a ball rests [s]
constexpr double step = 0.1;     ///< [s]

}  // namespace

Vec2 rolledOn(const Vec2& position, const Vec2& velocity, double seconds) {
  const double time = std::max(0.0, seconds);
  return position + ballRollingSeconds * (1 - std::exp(-time / ballRollingSeconds)) * velocity;
}

Vec2 restingPlace(const Vec2& position, const Vec2& velocity) {
  return velocity.norm() < slowest ? position : Vec2(position + ballRollingSeconds * velocity);
}

Vec2 meetingPlace(const Vec2& robot, double speed, const Vec2& position, const Vec2& velocity) {
  if (velocity.norm() < slowest) return position;
  const double keep = std::exp(-step / ballRollingSeconds);
  Vec2 place = position, way = ballRollingSeconds * velocity;
  for (double time = 0; time < latest; time += step) {
    if ((place - robot).norm() <= speed * time) return place;
    place += (1 - keep) * way;
    way *= keep;
  }
  return place + way;
}

}  // namespace plumbline
