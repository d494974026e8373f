#pragma once
#include <vector>

#include "framework/Module.h"
#include "motion/Gaze.h"
#include "representations/infrastructure/FieldDimensions.h"
#include "representations/infrastructure/FrameInfo.h"
#include "representations/modeling/BallPos.h"
#include "representations/modeling/RobotPose.h"
#include "representations/motion/HeadMotionRequest.h"
#include "tactics/BallSearch.h"

namespace plumbline {

MODULE(SimpleHeadMotion)
  REQUIRES(FrameInfo)
  USES(FieldDimensions)
  USES(BallPos)
  USES(RobotPose)
  PROVIDES(HeadMotionRequest)
  PARAMETER(double, ballMaxAge, 1, "s", Range(0, 60), "a ball that was not seen for longer is searched")
  PARAMETER_GROUP(motion::GazeParameters, gaze, "the joints of the head, its camera and its scan")
END_MODULE

/// Keeps the ball in view and, as far as that allows, many landmarks for the self-localisation; looks around
/// when the ball is lost or when the robot does not know where it is.
class SimpleHeadMotion : public SimpleHeadMotionBase {
public:
  void update(HeadMotionRequest* theHeadMotionRequest) override;

private:
  std::vector<Vec2> landmarks() const;

  double scanStart_ = -1;  ///< time when the scan began, negative while there is none [s]
  double scanFrom_ = 0;    ///< yaw of the head then [rad]
  double scanSide_ = 1;    ///< to which it turns first
};

}  // namespace plumbline
