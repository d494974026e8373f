#pragma once
#include "framework/Representation.h"
#include "math/Pose2.h"

namespace plumbline {

/// The robot on the field in its team's frame: origin at the centre, opponent goal at +x [m, rad].
REPRESENTATION(RobotPose)
class RobotPose : public RobotPoseBase {
public:
  Pose2 pose;                     ///< T_field_robot
  double positionDeviation = 10;  ///< standard deviation [m]
  double headingDeviation = 3;    ///< [rad]
  bool valid = false;             ///< localised well enough to act on it
  void stream(InStream* in, OutStream* out) override {
    STREAM("position", pose.position);
    STREAM("heading", pose.heading);
    STREAM(positionDeviation);
    STREAM(headingDeviation);
    STREAM(valid);
  }
};

}  // namespace plumbline
