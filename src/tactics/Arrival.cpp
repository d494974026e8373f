#include "tactics/Arrival.h"

#include <algorithm>
#include <cmath>

namespace plumbline {
namespace {

constexpr double leastWalk = 0.3;  ///< slower robots count as at rest: noise makes them seem to move [m/s]
constexpr double goesOn = 1;       ///< for which a velocity is believed [s]
constexpr double anyWay = 0.3;     ///< so far a robot goes in any direction without a turn [m]

double directionOf(const Vec2& way) { return std::atan2(way.y(), way.x()); }

}  // namespace

MovingRobot movedOn(const MovingRobot& robot, double seconds, const MovingSpeeds& speeds) {
  MovingRobot later = robot;
  later.getUpSeconds = std::max(0.0, robot.getUpSeconds - seconds);
  const double walks = seconds - (robot.getUpSeconds - later.getUpSeconds);
  if (robot.place) {
    const Vec2 way = robot.place->position - robot.position;
    const double distance = way.norm(), most = speeds.walk * walks;
    const bool arrives = distance <= most;
    later.position = arrives ? robot.place->position : Vec2(robot.position + most / distance * way);
    if (arrives)
      later.heading = robot.place->heading;
    else if (distance > anyWay)
      later.heading = directionOf(way);
    later.velocity = arrives ? Vec2(Vec2::Zero()) : Vec2(speeds.walk / distance * way);
    return later;
  }
  const double speed = robot.velocity.norm();
  if (speed < leastWalk || walks <= 0) return later;
  later.position += std::min(walks, goesOn) * std::min(1.0, speeds.walk / speed) * robot.velocity;
  return later;
}

double secondsTo(const MovingRobot& robot, const Vec2& to, const MovingSpeeds& speeds) {
  const Vec2 way = to - robot.position;
  const double distance = way.norm(), seconds = robot.getUpSeconds + distance / speeds.walk;
  if (distance < anyWay) return seconds;
  const bool walks = robot.velocity.norm() > leastWalk;
  if (!robot.heading && !walks) return seconds;
  const double heading = robot.heading ? *robot.heading : directionOf(robot.velocity);
  return seconds + std::abs(normalizeAngle(directionOf(way) - heading)) / speeds.turn;
}

}  // namespace plumbline
