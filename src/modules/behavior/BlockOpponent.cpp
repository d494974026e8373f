#include "modules/behavior/BlockOpponent.h"

#include "framework/DrawingSite.h"

namespace plumbline {

MAKE_MODULE(BlockOpponent)

void BlockOpponent::update(BlockPosition* theBlockPosition) {
  *theBlockPosition = {};
  if (!theBallPos->valid) return;
  const Vec2 ball = theBallPos->field, ownGoal(-theFieldDimensions->length / 2, 0);
  double least = goalReach;
  for (const OtherRobot& robot : theOtherRobots->robots) {
    if (robot.mate || robot.fallen) continue;
    const double toBall = (ball - robot.position).norm(), toGoal = (ownGoal - robot.position).norm();
    if (toBall < atBall || toBall > passReach || toGoal >= least || toGoal < distance) continue;
    least = toGoal;
    // The bisector of its ways: half a step aside stops the pass, half a step back the shot.
    const Vec2 way = (ball - robot.position) / toBall + (ownGoal - robot.position) / toGoal;
    const Vec2 to = way.norm() > 0.2 ? Vec2(way.normalized()) : Vec2((ownGoal - robot.position) / toGoal);
    theBlockPosition->valid = true;
    theBlockPosition->position = robot.position + distance * to;
    theBlockPosition->opponent = robot.number;
  }
  DEBUG_DRAWING("draw:BlockOpponent:place", {
    if (theBlockPosition->valid) drawing.circle(theBlockPosition->position, 0.2, colours::white);
  });
}

}  // namespace plumbline
