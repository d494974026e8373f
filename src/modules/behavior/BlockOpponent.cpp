#include "modules/behavior/BlockOpponent.h"

#include <algorithm>

#include "framework/DrawingSite.h"

namespace plumbline {

MAKE_MODULE(BlockOpponent)

/// Weak kicks that were seen do not make it shorter: they may have been meant so.
double BlockOpponent::reachOfPasses() const {
  return theOppInfo ? std::max(passReach, theOppInfo->kickDistance) : passReach;
}

void BlockOpponent::update(BlockPosition* theBlockPosition) {
  *theBlockPosition = {};
  if (!theBallPos->valid) return;
  const Vec2 ball = theBallPos->field, ownGoal(-theFieldDimensions->length / 2, 0);
  const double reach = reachOfPasses();
  double least = goalReach;
  for (const OtherRobot& robot : theOtherRobots->robots) {
    if (robot.mate || robot.fallen) continue;
    const double toBall = (ball - robot.position).norm(), toGoal = (ownGoal - robot.position).norm();
    if (toBall < atBall || toBall > reach || toGoal >= least || toGoal < distance) continue;
    least = toGoal;
    // The bisector of its ways: half a step aside stops the pass, half a step back the shot. If they lead
    // apart, a place between them stops neither, so the more they do, the more the one to the goal counts.
    const Vec2 pass = (ball - robot.position) / toBall, shot = (ownGoal - robot.position) / toGoal;
    const Vec2 to = (std::min(1.0, (pass + shot).norm()) * pass + shot).normalized();
    theBlockPosition->valid = true;
    theBlockPosition->position = robot.position + distance * to;
    theBlockPosition->opponent = robot.number;
  }
  DEBUG_DRAWING("draw:BlockOpponent:place", {
    if (theBlockPosition->valid) drawing.circle(theBlockPosition->position, 0.2, colours::white);
  });
}

}  // namespace plumbline
