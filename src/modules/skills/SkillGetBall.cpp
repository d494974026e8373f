#include "modules/skills/SkillGetBall.h"

#include <cmath>

#include "modules/skills/WalkConfig.h"

namespace plumbline {

MAKE_MODULE(SkillGetBall)

void SkillGetBall::init() {
  walk_ = readWalkToPose(config);
  approach_.avoidRadius = config.get<double>("avoidRadius", {0.1, 2.0});
  approach_.stepAngle = config.get<double>("stepAngle", {0.1, 1.5});
  approach_.behindAngle = config.get<double>("behindAngle", {0.1, 1.5});
  biasGain_ = config.get<double>("biasGain", {0, 10});
  biasDistance_ = config.get<double>("biasDistance", {0, 1});
  maxBias_ = config.get<double>("maxBias", {0, 1});
  dribbleBall_ = {config.get<double>("dribbleDistance", {0.05, 1.0}), 0};
}

Vec2 SkillGetBall::kickBallPosition() {
  // The foot on the ball's side, with some reluctance to change it.
  const double side = theBallPos->relative.y();
  if (side > 0.03) foot_ = Side::left;
  if (side < -0.03) foot_ = Side::right;
  Vec2 position = theSkillKickParameters->ballPosition;
  if (foot_ == Side::left) position.y() = -position.y();
  return position;
}

void SkillGetBall::learnBias(const Pose2& T_robot_target) {
  if (T_robot_target.position.norm() > biasDistance_ || std::abs(T_robot_target.heading) > 0.5) {
    bias_ = Vec2::Zero();
    return;
  }
  bias_ += biasGain_ * theFrameInfo->cycleSeconds * T_robot_target.position;
  if (const double size = bias_.norm(); size > maxBias_) bias_ *= maxBias_ / size;
}

void SkillGetBall::update(SkillGetBallOutput* theSkillGetBallOutput) {
  SkillOutput& output = theSkillGetBallOutput->output;
  output = {};
  theSkillGetBallOutput->atBall = false;
  const Skill skill = theSkillRequest->skill;
  if (skill != Skill::getBall && skill != Skill::kick && skill != Skill::dribble) return;

  output.active = skill == Skill::getBall;
  double heading = theSkillRequest->target.heading;
  if (skill != Skill::getBall) {
    const Vec2 toTarget = theSkillRequest->target.position - theBallPos->field;
    heading = std::atan2(toTarget.y(), toTarget.x());
  }
  heading = normalizeAngle(heading - theRobotPose->pose.heading);
  const Vec2 wanted = skill == Skill::dribble ? dribbleBall_ : kickBallPosition();
  const Pose2 way = approachBall(theBallPos->relative, heading, wanted, approach_);
  WalkCommand command = walkToPose(way, walk_);
  // A walk that drifts would come to rest short of the ball for ever (Seekircher 2015, 4.3).
  learnBias(way);
  command.velocity = limitVelocity(command.velocity + bias_, walk_);

  const Vec2 error = theBallPos->relative - wanted;
  const Vec2& tolerance = theSkillKickParameters->tolerance;
  theSkillGetBallOutput->atBall = std::abs(error.x()) < tolerance.x() &&
                                  std::abs(error.y()) < tolerance.y() &&
                                  std::abs(heading) < theSkillKickParameters->headingTolerance;
  output.motion = Motion::walk;
  output.walkVelocity = command.velocity;
  output.walkTurn = command.turn;
  output.kickFoot = foot_;
  output.kickBall = theBallPos->relative;
}

}  // namespace plumbline
