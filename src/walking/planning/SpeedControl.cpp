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
  if (std::abs(now_.x()) < std::abs(least)) now_.x() = least;
}

void SpeedControl::update(const Vec2& goal, double turn, const WalkParameters& p, double calm, double dt) {
  const Vec3 target = calm * sprint_.target(Vec3(goal.x(), goal.y(), turn), now_, p, dt);
  const bool braking = std::abs(target.x()) < std::abs(now_.x()) || target.x() * now_.x() < 0;
  Vec3 rate(braking ? p.speed.decelerationForward : p.speed.accelerationForward, p.speed.accelerationSideways,
            p.speed.accelerationTurn);
  const int axis = sprint_.axis();
  if (axis >= 0) rate[axis] = sprint_.acceleration(rate[axis], now_, p);
  const double before = now_.x();
  for (int i = 0; i < 3; ++i) now_[i] = approach(now_[i], target[i], rate[i] * dt);
  constexpr double average = 0.1;  // about a step [s]
  acceleration_ += std::min(1.0, dt / average) * ((now_.x() - before) / dt - acceleration_);
  // The robot brakes before it turns: the effort that forward speed leaves limits the rest.
  const Vec3 omni = omniLimits(now_.x(), p);
  const double used = std::abs(now_.x()) / omni.x();
  const double rest = std::max(axis == 0 ? p.sprint.lateralShare : 0.0, 1 - used);
  const double side = std::hypot(now_.y() / omni.y(), now_.z() / omni.z());
  if (side > rest && axis <= 0) {
    now_.y() *= rest / side;
    now_.z() *= rest / side;
  }
}

}  // namespace plumbline::walking
