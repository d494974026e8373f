#include "modules/skills/FootSelector.h"

#include <algorithm>
#include <cmath>

namespace plumbline {

MAKE_MODULE(FootSelector)

void FootSelector::update(ActiveFoot* theActiveFoot) {
  const Vec2& ball = theBallPos->field;
  const SkillOutput* skill = findSkill(allSkillOutputs, theSkillRequest->skill);
  const Vec2 way = skill && skill->playsBall() ? Vec2(theSkillRequest->target.position - ball)
                                               : Vec2(theSkillRequest->target.rotation() * Vec2::UnitX());
  if (way.norm() < 1e-6) return;
  const Vec2 left = Vec2(-way.y(), way.x()).normalized();
  double side = left.dot(theRobotPose->pose.position - ball);
  if (theOtherRobots) {
    const OtherRobot* nearest = nullptr;
    double least = opponentDistance;
    for (const OtherRobot& robot : theOtherRobots->robots) {
      const double distance = (robot.position - ball).norm();
      if (robot.mate || robot.fallen || distance >= least) continue;
      nearest = &robot;
      least = distance;
    }
    if (nearest) side += std::copysign(screenShift, left.dot(nearest->position - ball));
  }
  theActiveFoot->foot = footFor(side, theActiveFoot->foot, foot);
}

}  // namespace plumbline
