#include "walking/planning/Approach.h"

#include <algorithm>
#include <cmath>

#include "math/BrakingSpeed.h"
#include "walking/planning/ReferenceTrajectory.h"

namespace plumbline::walking {

ApproachPlan planApproach(const Pose2& target, const Vec2& velocity, double turn,
                          const WalkParameters& limits, const ApproachTolerance& tolerance,
                          std::size_t maxSteps) {
  ApproachPlan plan;
  const double time = limits.step.duration;
  Pose2 rest = target;
  Vec2 speed = velocity;
  double turnRate = turn;
  while (plan.steps.size() < maxSteps) {
    plan.complete = rest.position.norm() < tolerance.position && std::abs(rest.heading) < tolerance.heading;
    if (plan.complete) break;
    const double distance = rest.position.norm();
    Vec2 goal = Vec2::Zero();
    if (distance > 0) {
      // Along the straight line, limited by the slower of its parts; then by what can be braked.
      const Vec2 direction = rest.position / distance;
      const double forward = direction.x() >= 0 ? limits.speed.maxForward : limits.speed.maxBackward;
      const double fastest =
          1 / std::hypot(direction.x() / forward, direction.y() / limits.speed.maxSideways);
      const double deceleration = 0.7 / std::hypot(direction.x() / limits.speed.decelerationForward,
                                                   direction.y() / limits.speed.accelerationSideways);
      goal = direction * std::min({fastest, distance / time, brakingSpeed(distance, deceleration, time)});
    }
    const double angle = std::abs(rest.heading);
    double goalTurn = std::min(
        {limits.speed.maxTurn, angle / time, brakingSpeed(angle, 0.7 * limits.speed.accelerationTurn, time)});
    goalTurn = std::copysign(goalTurn, rest.heading);
    // Both share the effort as the walk does.
    const double effort =
        std::abs(goalTurn) / limits.speed.maxTurn +
        std::hypot(goal.x() / (goal.x() < 0 ? limits.speed.maxBackward : limits.speed.maxForward),
                   goal.y() / limits.speed.maxSideways);
    if (effort > 1) {
      goal /= effort;
      goalTurn /= effort;
    }
    const auto towards = [&](double from, double to, double most) {
      return from + std::clamp(to - from, -most, most);
    };
    const double along = std::abs(goal.x()) < std::abs(speed.x()) ? limits.speed.decelerationForward
                                                                  : limits.speed.accelerationForward;
    speed.x() = towards(speed.x(), goal.x(), along * time);
    speed.y() = towards(speed.y(), goal.y(), limits.speed.accelerationSideways * time);
    turnRate = towards(turnRate, goalTurn, limits.speed.accelerationTurn * time);
    if (plan.steps.empty()) {
      plan.velocity = speed;
      plan.turn = turnRate;
    }
    const Pose2 step = arc(speed, turnRate, time);
    plan.steps.push_back(step);
    rest = step.inverse() * rest;
    speed = Eigen::Rotation2Dd(-step.heading) * speed;
  }
  return plan;
}

}  // namespace plumbline::walking
