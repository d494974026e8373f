#include "simulation/referee/BallWatch.h"

#include <cmath>

#include "simulation/Field.h"

namespace plumbline::simulation {

using simspark::TeamSide;

namespace {
constexpr double tolerance = 0.001;  ///< the league server's [m]
constexpr double goalLine =
    fieldLength / 2 + ballRadius;  ///< of the centre of a ball that is all behind it [m]
bool betweenPosts(double y, double z) { return std::fabs(y) < goalWidth / 2 && z < goalHeight; }
}  // namespace

void BallWatch::update(const Vec3& ballPosition) {
  previous = current;
  current = ballPosition;
  if (onField()) valid = current;
}

bool BallWatch::onField() const {
  return std::fabs(current.x()) < goalLine + tolerance &&
         std::fabs(current.y()) < fieldWidth / 2 + ballRadius + tolerance;
}

TeamSide BallWatch::inGoalOf() const {
  if (std::fabs(current.x()) < goalLine) return TeamSide::none;
  const TeamSide side = current.x() < 0 ? TeamSide::left : TeamSide::right;
  const double line = std::copysign(goalLine, current.x());
  const bool wasBehind = previous.x() * std::copysign(1.0, line) >= goalLine;
  if (wasBehind)  // it came in from elsewhere, or a trainer put it there
    return betweenPosts(current.y(), current.z()) && std::fabs(current.x()) < fieldLength / 2 + goalDepth
               ? side
               : TeamSide::none;
  const double t = (line - previous.x()) / (current.x() - previous.x());
  const Vec3 crossing = previous + t * (current - previous);
  return betweenPosts(crossing.y(), crossing.z()) ? side : TeamSide::none;
}

}  // namespace plumbline::simulation
