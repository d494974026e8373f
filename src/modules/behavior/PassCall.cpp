#include "modules/behavior/PassCall.h"

#include "framework/DrawingSite.h"

namespace plumbline {

MAKE_MODULE(PassCall)

void PassCall::update(PassRequest* thePassRequest) {
  const PlayerRole& role = *thePlayerRole;
  const Vec2& ball = theBallPos->field;
  thePassRequest->active = theGameState->playMode == TeamPlayMode::playOn && role.members > 1 &&
                           role.role == PlayerRole::striker && role.mayTouchBall && theRobotPose->valid &&
                           theBallPos->valid && theBallPos->relative.norm() < reach &&
                           (theFieldDimensions->opponentGoal() - ball).norm() > goalDistance &&
                           theOtherRobots->nearestOpponent(ball) < threat;
  // The circle that opponents must leave.
  DEBUG_DRAWING("draw:team:pass", {
    if (!thePassRequest->active) return;
    drawing.circle(ball, 1, colours::violet, 3);
    drawing.text(ball, "pass mode?", colours::violet);
  });
}

}  // namespace plumbline
