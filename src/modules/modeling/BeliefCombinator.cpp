#include "modules/modeling/BeliefCombinator.h"

#include <cmath>

#include "modules/modeling/others/CombineRobots.h"

namespace plumbline {

MAKE_MODULE(BeliefCombinator)

void BeliefCombinator::roll(double dt) {
  const double keep = std::exp(-dt / rollingTimeConstant);
  position_ += rollingTimeConstant * (1 - keep) * velocity_;
  velocity_ *= keep;
}

void BeliefCombinator::hear(BallPos& ball) {
  const TeamBallPos& team = *theTeamBallPos;
  const double own = theLocalBallPos->valid ? ball.age : 1e3;
  if (!team.valid || !theRobotPose->valid || own <= ownBallSeconds || team.age >= own) return;
  position_ = team.field;
  velocity_ = team.velocity;
  onField_ = true;
  ball.valid = true;
  ball.age = team.age;
}

void BeliefCombinator::update(OtherRobots* theOtherRobots) {
  static const std::vector<OtherRobot> nobody;
  theOtherRobots->robots = combineRobots(theLocalOtherRobots ? theLocalOtherRobots->robots : nobody,
                                         theTeamOtherRobots ? theTeamOtherRobots->robots : nobody,
                                         theFrameInfo->time, ownRobotSeconds);
}

void BeliefCombinator::update(BallPos* theBallPos) {
  const LocalBallPos& local = *theLocalBallPos;
  const Pose2& robot = theRobotPose->pose;
  theBallPos->valid = local.valid;
  theBallPos->age = local.lastSeen < 0 ? 1e3 : theFrameInfo->time - local.lastSeen;

  roll(theFrameInfo->cycleSeconds);
  const bool fresh = theBallPos->age <= freshSeconds;
  if (theFrameInfo->restarted || !theRobotPose->valid) onField_ = false;
  if (fresh || !onField_) {
    position_ = robot * local.position;
    velocity_ = robot.rotation() * local.velocity;
    onField_ = fresh && theRobotPose->valid;
  }
  if (theTeamBallPos) hear(*theBallPos);
  theBallPos->field = position_;
  theBallPos->relative = robot.inverse() * position_;
  theBallPos->relativeVelocity = robot.rotation().transpose() * velocity_;
}

}  // namespace plumbline
