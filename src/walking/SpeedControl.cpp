#include "walking/SpeedControl.h"

#include <algorithm>
#include <cmath>

namespace plumbline::walking {
namespace {

double approach(double value, double goal, double maxChange) {
  return value + std::clamp(goal - value, -maxChange, maxChange);
}

/// A speed between two gaits is walked at the lower one's.
double outsideGap(double speed, double full, double blendStart) {
  constexpr double nearlyFull = 0.9;
  const double share = std::abs(speed) / full;
  return blendStart > 0 && share < nearlyFull ? std::copysign(std::min(share, blendStart) * full, speed)
                                              : speed;
}

}  // namespace

void SpeedControl::update(Vec2 goal, double goalTurn, const WalkParameters& p, double calm, double dt) {
  const double forward = goal.x() < 0 ? p.maxBackward : p.maxForward;
  const double effort = std::hypot(goal.x() / forward, goal.y() / p.maxSideways, goalTurn / p.maxTurn);
  if (effort > 1) {
    goal /= effort;
    goalTurn /= effort;
  }
  goal.x() = outsideGap(goal.x(), forward, p.blendStart);
  goal.y() = outsideGap(goal.y(), p.maxSideways, p.blendStart);
  goalTurn = outsideGap(goalTurn, p.maxTurn, p.blendStart);
  goal *= calm;
  goalTurn *= calm;
  const bool braking = std::abs(goal.x()) < std::abs(velocity_.x()) || goal.x() * velocity_.x() < 0;
  velocity_.x() =
      approach(velocity_.x(), goal.x(), (braking ? p.decelerationForward : p.accelerationForward) * dt);
  velocity_.y() = approach(velocity_.y(), goal.y(), p.accelerationSideways * dt);
  turn_ = approach(turn_, goalTurn, p.accelerationTurn * dt);
  // The robot brakes before it turns: what forward speed leaves of the effort limits the rest.
  const double used = velocity_.x() / (velocity_.x() < 0 ? -p.maxBackward : p.maxForward);
  const double rest = std::max(0.0, 1 - used);
  const double side = std::hypot(velocity_.y() / p.maxSideways, turn_ / p.maxTurn);
  if (side > rest) {
    velocity_.y() *= rest / side;
    turn_ *= rest / side;
  }
}

}  // namespace plumbline::walking
