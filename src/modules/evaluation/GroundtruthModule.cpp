#include "modules/evaluation/GroundtruthModule.h"

#include "math/GroundPose.h"

namespace plumbline {

MAKE_MODULE(GroundtruthModule)

void GroundtruthModule::execute() {
  if (!theGroundTruth->valid) {
    if (!warned_) log.warning() << "no ground truth: start the simulator with its ground truth option";
    warned_ = true;
    seen_ = false;
    return;
  }
  robot_ = groundPose(theGroundTruth->T_field_torso);
  const Vec2 ball = theGroundTruth->ball.head<2>();
  if (theFrameInfo->restarted) seen_ = false;
  ballVelocity_ = seen_ ? Vec2((ball - ballBefore_) / theFrameInfo->cycleSeconds) : Vec2(Vec2::Zero());
  ballBefore_ = ball;
  seen_ = true;
}

void GroundtruthModule::update(RobotPose* theRobotPose) {
  theRobotPose->pose = robot_;
  theRobotPose->positionDeviation = theRobotPose->headingDeviation = 0;
  theRobotPose->valid = theGroundTruth->valid;
}

void GroundtruthModule::update(BallPos* theBallPos) {
  theBallPos->field = ballBefore_;
  theBallPos->relative = robot_.inverse() * ballBefore_;
  theBallPos->relativeVelocity = robot_.rotation().transpose() * ballVelocity_;
  theBallPos->age = seen_ ? 0 : 1e3;
  theBallPos->valid = theGroundTruth->valid;
}

}  // namespace plumbline
