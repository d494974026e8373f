#include "modules/motion/SimpleHeadMotion.h"

namespace plumbline {

MAKE_MODULE(SimpleHeadMotion)

void SimpleHeadMotion::init() {
  ballMaxAge_ = config.get<double>("ballMaxAge", {0, 60});
  gaze_.maxYaw = config.get<double>("maxYaw", {0, 2.09});
  gaze_.maxPitch = config.get<double>("maxPitch", {0, 0.78});
  gaze_.minPitch = config.get<double>("minPitch", {-0.78, 0});
  gaze_.halfView = config.get<double>("halfView", {0.1, 1.5});
  gaze_.ballMargin = config.get<double>("ballMargin", {0, 1});
  gaze_.cameraHeight = config.get<double>("cameraHeight", {0.1, 2});
  gaze_.scanYaw = config.get<double>("scanYaw", {0, 2.09});
  gaze_.scanSeconds = config.get<double>("scanSeconds", {0.5, 60});
}

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
  const bool ballKnown = theBallPos && theBallPos->valid && theBallPos->age < ballMaxAge_;
  motion::HeadAngles head;
  if (ballKnown) {
    scanStart_ = -1;
    scanSide_ = theBallPos->relative.y() >= 0 ? 1 : -1;
    std::optional<Pose2> robot;
    if (localised) robot = theRobotPose->pose;
    head = lookAtBall(theBallPos->relative, robot, landmarks(), theHeadMotionRequest->yaw, gaze_);
  } else {
    if (scanStart_ < 0) scanStart_ = theFrameInfo->time;
    head = scan(theFrameInfo->time - scanStart_, scanSide_, gaze_);
  }
  theHeadMotionRequest->yaw = head.yaw;
  theHeadMotionRequest->pitch = head.pitch;
}

}  // namespace plumbline
