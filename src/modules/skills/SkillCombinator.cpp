#include "modules/skills/SkillCombinator.h"

#include "framework/DrawingSite.h"

namespace plumbline {

MAKE_MODULE(SkillCombinator)

Vec2 SkillCombinator::withoutCharging(const Vec2& velocity) {
  if (!theRobotPose || !theBallPos || !theOtherRobots || !theRobotPose->valid) return velocity;
  const Pose2 toRobot = theRobotPose->pose.inverse();
  std::vector<Vec2> opponents;
  for (const OtherRobot& robot : theOtherRobots->robots)
    if (!robot.mate && !robot.fallen) opponents.push_back(toRobot * robot.position);
  return guard_.allowed(velocity, theBallPos->relative, opponents, charge, theFrameInfo->cycleSeconds);
}

Vec2 SkillCombinator::outsideArea(const Vec2& velocity) const {
  if (!thePlayerRole || thePlayerRole->mayBeInOwnArea || !theFieldDimensions || !theRobotPose ||
      !theRobotPose->valid)
    return velocity;
  const Pose2& robot = theRobotPose->pose;
  const OwnArea own(theFieldDimensions->size());
  return robot.rotation().transpose() *
         own.stoppedBefore(robot.rotation() * velocity, robot.position, areaBrakeSeconds);
}

void SkillCombinator::update(MotionRequest* theMotionRequest) {
  theMotionRequest->motion = Motion::stand;
  theMotionRequest->walkVelocity = Vec2::Zero();
  theMotionRequest->walkTurn = 0;
  theMotionRequest->atOnce = false;
  for (const SkillOutput* output : allSkillOutputs) {
    if (!output->active) continue;
    theMotionRequest->motion = output->motion;
    theMotionRequest->walkVelocity = output->walkVelocity;
    theMotionRequest->walkTurn = output->walkTurn;
    theMotionRequest->specialAction = output->specialAction;
    theMotionRequest->atOnce = output->atOnce;
    theMotionRequest->kick = output->kick;
    theMotionRequest->kickFoot = output->kickFoot;
    theMotionRequest->kickBall = output->kickBall;
    break;
  }
  theMotionRequest->walkVelocity = outsideArea(withoutCharging(theMotionRequest->walkVelocity));
  DEBUG_DRAWING("draw:SkillCombinator:request", {
    const MotionRequest& request = *theMotionRequest;
    drawing.in(DrawingFrame::robot);
    drawing.text(Vec3(0, 0, 0.7), request.motion, colours::white);
    drawing.arrow(Vec2(0, 0), request.walkVelocity, colours::green, 3);
    drawing.arrow(request.walkVelocity, Vec2(request.walkVelocity + Vec2(0, request.walkTurn)), colours::blue,
                  3);
  });
}

}  // namespace plumbline
