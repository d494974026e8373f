#include "modules/modeling/BeliefCombinator.h"

#include <fmt/format.h>

#include <cmath>

#include "framework/DrawingSite.h"
#include "modules/modeling/others/CombineRobots.h"
#include "modules/modeling/others/RobotDrawing.h"
#include "tactics/RollingBall.h"

namespace plumbline {

MAKE_MODULE(BeliefCombinator)

void BeliefCombinator::roll(double dt) {
  const double keep = std::exp(-dt / ballRollingSeconds);
  position_ += ballRollingSeconds * (1 - keep) * velocity_;
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
  DEBUG_DRAWING("draw:belief:robots", drawRobots(drawing, theOtherRobots->robots, beliefColours::combined));
}

/// The ball by own sight, by messages and by both; how uncertain it is, as two standard deviations.
void BeliefCombinator::drawBall(Drawing& drawing, const BallPos& ball) const {
  const LocalBallPos& own = *theLocalBallPos;
  if (own.valid && theRobotPose->valid)
    drawing.circle(Vec2(theRobotPose->pose * own.position), 2 * own.deviation, beliefColours::sight);
  if (theTeamBallPos && theTeamBallPos->valid)
    drawing.circle(theTeamBallPos->field, 2 * theTeamBallPos->deviation, beliefColours::heard);
  if (!ball.valid) return;
  drawing.sphere(Vec3(ball.field.x(), ball.field.y(), 0.042), 0.06, beliefColours::combined);
  drawing.text(ball.field, fmt::format("ball {:.1f} s", ball.age), beliefColours::combined);
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
  DEBUG_DRAWING("draw:belief:ball", drawBall(drawing, *theBallPos));
}

}  // namespace plumbline
