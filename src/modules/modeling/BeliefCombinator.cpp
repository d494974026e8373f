#include "modules/modeling/BeliefCombinator.h"

namespace plumbline {

MAKE_MODULE(BeliefCombinator)

void BeliefCombinator::update(BallPos* theBallPos) {
  const LocalBallPos& local = *theLocalBallPos;
  theBallPos->valid = local.valid;
  theBallPos->age = local.lastSeen < 0 ? 1e3 : theFrameInfo->time - local.lastSeen;
  theBallPos->relative = local.position;
  theBallPos->relativeVelocity = local.velocity;
  theBallPos->field = theRobotPose->pose * local.position;
}

}  // namespace plumbline
