#include "modules/behavior/PassCall.h"

namespace plumbline {

MAKE_MODULE(PassCall)

void PassCall::update(PassRequest* thePassRequest) {
  const PlayerRole& role = *thePlayerRole;
  const Vec2& ball = theBallPos->field;
  thePassRequest->active = theGameState->playMode == PlayMode::playOn && role.members > 1 &&
                           role.role == PlayerRole::striker && role.mayTouchBall && theRobotPose->valid &&
                           theBallPos->valid && theBallPos->relative.norm() < reach &&
                           (theFieldDimensions->opponentGoal() - ball).norm() > goalDistance &&
                           theOtherRobots->nearestOpponent(ball) < threat;
}

}  // namespace plumbline
