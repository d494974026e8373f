#include "tactics/approach/BallApproach.h"

#include <algorithm>
#include <cmath>

namespace plumbline {

Pose2 approachBall(const Vec2& ball, double heading, const Vec2& ballInTarget,
                   const BallApproachParameters& parameters) {
  const Mat2 R = Eigen::Rotation2Dd(heading).toRotationMatrix();
  Pose2 goal(Vec2(ball - R * ballInTarget), heading);

  // The robot's place around the ball, as an angle from the wanted one.
  const Vec2 fromBall = -ball;
  const Vec2 goalFromBall = goal.position - ball;
  const double angle =
      normalizeAngle(std::atan2(fromBall.y(), fromBall.x()) - std::atan2(goalFromBall.y(), goalFromBall.x()));
  if (std::abs(angle) < parameters.behindAngle) return goal;

  // Far away the straight way to the goal pose is free unless it passes the ball closely.
  const Vec2 direction = goal.position.normalized();
  const double along = std::clamp(ball.dot(direction), 0.0, goal.position.norm());
  const double clearance = (ball - along * direction).norm();
  if (clearance > parameters.avoidRadius && fromBall.norm() > 1.5 * parameters.avoidRadius) return goal;

  // Around the ball on the shorter side.
  const double turn = std::copysign(std::min(std::abs(angle), parameters.stepAngle), -angle);
  const double distance = fromBall.norm();
  const double radius = std::clamp(distance, parameters.avoidRadius, parameters.avoidRadius * 1.2);
  const double here = std::atan2(fromBall.y(), fromBall.x());
  const Vec2 point = ball + radius * Vec2(std::cos(here + turn), std::sin(here + turn));
  const Vec2 toBall = ball - point;
  return Pose2(point, std::atan2(toBall.y(), toBall.x()));
}

}  // namespace plumbline
