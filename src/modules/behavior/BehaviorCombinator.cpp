#include "modules/behavior/BehaviorCombinator.h"

#include <cmath>

#include "framework/DrawingSite.h"
#include "tactics/OwnArea.h"

namespace plumbline {

MAKE_MODULE(BehaviorCombinator)

const BehaviorOutput* BehaviorCombinator::active() const {
  for (const BehaviorOutput* output : allBehaviorOutputs)
    if (output->active) return output;
  return nullptr;
}

void BehaviorCombinator::keepOutOfArea(SkillRequest& request) const {
  if (!thePlayerRole || thePlayerRole->mayBeInOwnArea || !theFieldDimensions || !theRobotPose ||
      !theRobotPose->valid)
    return;
  const OwnArea area(theFieldDimensions->size());
  const Pose2& robot = theRobotPose->pose;
  if (request.skill == Skill::moveToPos)
    request.target.position = area.keptOut(request.target.position, OwnArea::waitDistance);
  if (area.distance(robot.position) >= OwnArea::leaveDistance) return;
  if (request.skill == Skill::moveToPos && area.distance(request.target.position) >= OwnArea::waitDistance)
    return;
  const Vec2 toBall = theBallPos ? Vec2(theBallPos->field - robot.position) : Vec2::UnitX();
  request.skill = Skill::moveToPos;
  request.target =
      Pose2(area.keptOut(robot.position, OwnArea::waitDistance), std::atan2(toBall.y(), toBall.x()));
}

void BehaviorCombinator::update(SkillRequest* theSkillRequest) {
  const BehaviorOutput* output = active();
  theSkillRequest->skill = output ? output->skill : Skill::stand;
  theSkillRequest->target = output ? output->target : Pose2();
  theSkillRequest->tolerance = output ? output->tolerance : 0;
  if (output && !output->beam) keepOutOfArea(*theSkillRequest);
  DEBUG_DRAWING("draw:BehaviorCombinator:target", {
    if (!output) return;
    drawing.circle(output->target.position, 0.15, colours::red);
    drawing.pose(output->target, 0.4, colours::red);
    drawing.text(output->target.position, output->skill, colours::red);
  });
}

void BehaviorCombinator::update(BeamRequest* theBeamRequest) {
  const BehaviorOutput* output = active();
  theBeamRequest->active = output && output->beam;
  if (theBeamRequest->active) theBeamRequest->pose = output->beamPose;
}

}  // namespace plumbline
