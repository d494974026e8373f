#include "tactics/approach/WalkForecast.h"

#include <algorithm>
#include <cmath>

namespace plumbline {
namespace {

constexpr double leastShare = 0.1;  ///< of the limits sideways and in turning that full speed leaves

double towards(double from, double to, double most) { return from + std::clamp(to - from, -most, most); }

}  // namespace

WalkPoint coasted(WalkPoint point, double seconds) {
  const double middle = point.pose.heading + point.speed.z() * seconds / 2;
  const double c = std::cos(middle), s = std::sin(middle), x = point.speed.x(), y = point.speed.y();
  point.pose.position += seconds * Vec2(c * x - s * y, s * x + c * y);
  point.pose.heading = normalizeAngle(point.pose.heading + point.speed.z() * seconds);
  return point;
}

WalkPoint walked(WalkPoint point, const Vec3& request, const WalkLimits& limits, double seconds) {
  Vec3& speed = point.speed;
  const double most = request.x() >= 0 ? limits.forward : limits.backward;
  const double asked =
      std::sqrt(std::pow(request.x() / most, 2) + std::pow(request.y() / limits.sideways, 2) +
                std::pow(request.z() / limits.turn, 2));
  const Vec3 goal = asked > 1 ? Vec3(request / asked) : request;
  const bool brakes = std::abs(goal.x()) < std::abs(speed.x()) || goal.x() * speed.x() < 0;
  const double along = brakes ? limits.decelerationForward : limits.accelerationForward;
  speed.x() = towards(speed.x(), goal.x(), along * seconds);
  speed.y() = towards(speed.y(), goal.y(), limits.accelerationSideways * seconds);
  speed.z() = towards(speed.z(), goal.z(), limits.accelerationTurn * seconds);
  const double used = std::abs(speed.x()) / (speed.x() >= 0 ? limits.forward : limits.backward);
  const double rest = std::max(leastShare, 1 - used);
  const double aside = std::hypot(speed.y() / limits.sideways, speed.z() / limits.turn);
  if (aside > rest) speed.tail<2>() *= rest / aside;
  return coasted(point, seconds);
}

}  // namespace plumbline
