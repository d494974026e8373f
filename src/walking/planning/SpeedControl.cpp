#include "walking/planning/SpeedControl.h"

#include <cmath>

namespace plumbline::walking {
namespace {

double approach(double value, double goal, double maxChange) {
  return value + std::clamp(goal - value, -maxChange, maxChange);
}

}  // namespace

void SpeedControl::begin(const Vec2& goal, const WalkParameters& p) {
  const double least = std::clamp(goal.x(), -p.startStop.speed, p.startStop.speed);
  if (std::abs(now.x()) < std::abs(least)) now.x() = least;
}

void SpeedControl::update(const Vec2& goal, double turn, const WalkParameters& p, double calm, double dt) {
  const Vec3 target = calm * sprint.target(Vec3(goal.x(), goal.y(), turn), now, p, dt);
  const bool braking = std::abs(target.x()) < std::abs(now.x()) || target.x() * now.x() < 0;
  Vec3 rate(braking ? p.speed.decelerationForward : p.speed.accelerationForward, p.speed.accelerationSideways,
            p.speed.accelerationTurn);
  const int axis = sprint.axis();
  if (axis >= 0) rate[axis] = sprint.acceleration(rate[axis], now, p);
  const double before = now.x();
  for (int i = 0; i < 3; ++i) now[i] = approach(now[i], target[i], rate[i] * dt);
  constexpr double average = 0.1;  // about a step [s]
  acceleration_ += std::min(1.0, dt / average) * ((now.x() - before) / dt - acceleration_);
  // The robot brakes before it turns: what forward speed leaves of the effort limits the rest.
  const Vec3 omni = omniLimits(now.x(), p);
  const double used = std::abs(now.x()) / omni.x();
  const double rest = std::max(axis == 0 ? p.sprint.lateralShare : 0.0, 1 - used);
  const double side = std::hypot(now.y() / omni.y(), now.z() / omni.z());
  if (side > rest && axis <= 0) {
    now.y() *= rest / side;
    now.z() *= rest / side;
  }
}

}  // namespace plumbline::walking
