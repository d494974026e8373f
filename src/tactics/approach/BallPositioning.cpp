#include "tactics/approach/BallPositioning.h"

#include <cmath>

namespace plumbline {

void BallPositioning::learnBias(const Pose2& T_robot_target, const BallPositioningParameters& p, double dt) {
  if (T_robot_target.position.norm() > p.biasDistance || std::abs(T_robot_target.heading) > 0.5) {
    bias_ = Vec2::Zero();
    return;
  }
  bias_ += p.biasGain * dt * T_robot_target.position;
  if (const double size = bias_.norm(); size > p.maxBias) bias_ *= p.maxBias / size;
}

bool BallPositioning::exact(const Wish& wish, const Vec2& error, const BallPositioningParameters& p) const {
  const double tolerances = atBall_ ? p.leaveTolerances : 1;
  const double most = tolerances * wish.headingTolerance.value_or(wish.hurry * p.toleranceHeading);
  return std::abs(error.x()) < tolerances * wish.hurry * p.toleranceForward &&
         std::abs(error.y()) < tolerances * wish.hurry * p.toleranceSideways && std::abs(wish.heading) < most;
}

Pose2 BallPositioning::placeOf(const Wish& wish) {
  return Pose2(Vec2(wish.ball - Eigen::Rotation2Dd(wish.heading) * wish.place), wish.heading);
}

std::vector<Pose2> BallPositioning::plannedWay(const Wish& wish, const BallPositioningParameters& p) const {
  return planner_.way({placeOf(wish).inverse(), wish.speed}, wish.place, wish.beyond, wish.limits, p.plan);
}

WalkCommand BallPositioning::update(const Wish& wish, const Vec2& ball, const BallPositioningParameters& p,
                                    double dt) {
  Pose2 way = approachBall(wish.ball, wish.heading, wish.place, p.approach);
  const bool lastPart = std::abs(way.heading - wish.heading) < 1e-9;
  if (lastPart) way.position += wish.beyond * Vec2(std::cos(wish.heading), std::sin(wish.heading));
  const bool plans =
      !wish.detour && ApproachPlanner::plansFrom(wish.ball.norm(), sprinting_, wish.limits, p.plan);
  WalkCommand command = plans         ? planner_.update({placeOf(wish).inverse(), wish.speed}, wish.place,
                                                        wish.beyond, wish.limits, p.plan)
                        : wish.detour ? walkPast(*wish.detour, p.walk, sprinting_)
                                      : walkToPose(way, p.walk, sprinting_);
  if (!plans) planner_.leave();
  sprinting_ = command.sprint;
  // A walk that drifts would come to rest short of the ball for ever (Seekircher 2015, 4.3).
  if (!atBall_) learnBias(way, p, dt);
  command.velocity += bias_;
  if (!plans) command.velocity = limitVelocity(command.velocity, p.walk);
  atBall_ = exact(wish, ball - wish.place, p);
  return command;
}

}  // namespace plumbline
