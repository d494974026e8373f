#include "tactics/approach/BallPath.h"

#include <algorithm>
#include <cmath>

#include "math/Angle.h"

namespace plumbline {
namespace {

constexpr double outside = 1.05;  ///< radius of way points: a chord to the next one cuts the circle
constexpr double straight =
    1.2;  ///< radii from the ball from which the straight way to the place may be free
constexpr double closingIn = 0.8;  ///< share of behindAngle at which the circle is left, so that it is passed

Vec2 onCircle(const Vec2& ball, double radius, double angle) {
  return ball + radius * Vec2(std::cos(angle), std::sin(angle));
}

bool straightWayIsFree(const Vec2& position, const Vec2& ball, double radius) {
  const double length = position.norm();
  if (length < 1e-9) return true;
  const Vec2 direction = -position / length;
  const double along = std::clamp(direction.dot(ball - position), 0.0, length);
  return (position + along * direction - ball).norm() > radius;
}

}  // namespace

BallPath pathToPlace(const Vec2& position, const Vec2& ball, Around side, const BallApproachParameters& p) {
  BallPath direct{.next = Vec2::Zero(), .length = position.norm(), .last = true};
  const Vec2 from = position - ball;
  const double distance = from.norm(), radius = p.avoidRadius;
  const double here = std::atan2(from.y(), from.x()), place = std::atan2(-ball.y(), -ball.x());
  if (std::abs(normalizeAngle(here - place)) < p.behindAngle) return direct;
  if (distance > straight * radius && straightWayIsFree(position, ball, radius)) return direct;

  const double sign = side == Around::counterclockwise ? 1 : -1;
  double around = std::fmod(sign * (place - here), 2 * pi);  // angle to the place, 0 .. 2 pi
  if (around < 0) around += 2 * pi;
  around = std::max(0.0, around - closingIn * p.behindAngle);
  const double tangent = distance > radius ? std::acos(radius / distance) : 0;
  const double next = std::min(around, std::max(tangent, p.stepAngle));
  BallPath path;
  path.next = onCircle(ball, outside * radius, here + sign * next);
  path.length = (path.next - position).norm() + radius * (around - next) +
                onCircle(ball, outside * radius, here + sign * around).norm();
  return path;
}

}  // namespace plumbline
