#pragma once
#include "framework/Representation.h"
#include "math/Pose2.h"

namespace plumbline {

/// Standard deviation of the odometry, share of the distance walked.
inline constexpr double odometryErrorShare = 0.05;

/// Motion of the robot's ground frame since the last cycle, and its sum since the start.
REPRESENTATION(Odometry)
class Odometry : public OdometryBase {
public:
  Pose2 step;  ///< T_before_now
  Pose2 total;
  void stream(InStream* in, OutStream* out) override {
    STREAM("stepPosition", step.position);
    STREAM("stepHeading", step.heading);
    STREAM("totalPosition", total.position);
    STREAM("totalHeading", total.heading);
  }
};

}  // namespace plumbline
