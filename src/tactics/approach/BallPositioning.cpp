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
  const double stays = atBall_ ? p.keeps : 1;
  const double most = stays * wish.headingTolerance.value_or(wish.hurry * p.toleranceHeading);
  return std::abs(error.x()) < stays * wish.hurry * p.toleranceForward &&
         std::abs(error.y()) < stays * wish.hurry * p.toleranceSideways && std::abs(wish.heading) < most;
}

WalkCommand BallPositioning::update(const Wish& wish, const Vec2& ball, const BallPositioningParameters& p,
                                    double dt) {
  // Where the robot will be, in its present frame.
  const double turned = p.lead * wish.speed.heading;
  const Pose2 later(p.lead * (Eigen::Rotation2Dd(turned / 2) * wish.speed.position), turned);
  const Pose2 toLater = later.inverse();
  const double heading = normalizeAngle(wish.heading - turned);
  Pose2 way = approachBall(toLater * wish.ball, heading, wish.place, p.approach);
  const bool lastPart = std::abs(way.heading - heading) < 1e-9;
  if (lastPart) way.position += wish.beyond * Vec2(std::cos(heading), std::sin(heading));
  WalkCommand command = wish.detour ? walkPast(toLater * *wish.detour, p.walk, sprinting_)
                                    : walkToPose(way, p.walk, sprinting_);
  sprinting_ = command.sprint;
  // A walk that drifts would come to rest short of the ball for ever (Seekircher 2015, 4.3).
  if (!atBall_) learnBias(way, p, dt);
  command.velocity = limitVelocity(command.velocity + bias_, p.walk);
  atBall_ = exact(wish, ball - wish.place, p);
  return command;
}

}  // namespace plumbline
