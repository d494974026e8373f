#include "modules/behavior/formation/TimeToBall.h"

#include <cmath>

namespace plumbline {

double timeToBall(const Pose2& player, bool fallen, const Vec2& ball, const Vec2& goal,
                  const TimeToBallParameters& parameters) {
  const Vec2 way = ball - player.position, aim = goal - ball;
  const double distance = way.norm();
  double time = distance / parameters.walkSpeed;
  if (fallen) time += parameters.getUp;
  if (distance < 1e-6) return time;
  const double bearing = normalizeAngle(std::atan2(way.y(), way.x()) - player.heading);
  time += std::abs(bearing) / parameters.turnSpeed;
  const double length = distance * aim.norm();
  if (length > 1e-6) time += parameters.wrongSide * 0.5 * (1 - way.dot(aim) / length);
  return time;
}

}  // namespace plumbline
