#include "modules/motion/SimpleHeadMotion.h"

namespace plumbline {

MAKE_MODULE(SimpleHeadMotion)

std::vector<Vec2> SimpleHeadMotion::landmarks() const {
  std::vector<Vec2> points;
  if (!theFieldDimensions) return points;
  const Vec2 corner(theFieldDimensions->length / 2, theFieldDimensions->width / 2);
  for (const double x : {-corner.x(), corner.x()})
    for (const double y : {corner.y(), theFieldDimensions->goalWidth / 2})
      for (const double side : {-1.0, 1.0}) points.emplace_back(x, side * y);
  return points;
}

void SimpleHeadMotion::update(HeadMotionRequest* theHeadMotionRequest) {
  const bool localised = theRobotPose && theRobotPose->valid;
  const bool ballKnown = theBallPos && theBallPos->valid && theBallPos->age < ballMaxAge;
  motion::HeadAngles head;
  if (ballKnown) {
    scanStart_ = -1;
    std::optional<Pose2> robot;
    if (localised) robot = theRobotPose->pose;
    head = lookAtBall(theBallPos->relative, robot, landmarks(), theHeadMotionRequest->yaw, gaze);
  } else {
    if (scanStart_ < 0) {
      scanStart_ = theFrameInfo->time;
      scanFrom_ = theHeadMotionRequest->yaw;
      scanSide_ = BallSearch::sideAwayFrom(theBallPos ? theBallPos->relative : Vec2(Vec2::Zero()));
    }
    head = scan(theFrameInfo->time - scanStart_, scanFrom_, scanSide_, gaze);
  }
  theHeadMotionRequest->yaw = head.yaw;
  theHeadMotionRequest->pitch = head.pitch;
}

}  // namespace plumbline
