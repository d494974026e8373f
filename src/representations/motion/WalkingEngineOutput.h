#pragma once
#include "math/Pose2.h"
#include "representations/motion/MotionOutput.h"
#include "robot/WalkLimits.h"

namespace plumbline {

/// The walk; it is finished when the robot stands on both feet.
REPRESENTATION_OF(WalkingEngineOutput, MotionOutput)
class WalkingEngineOutput : public WalkingEngineOutputBase {
public:
  WalkingEngineOutput() : WalkingEngineOutputBase(Motion::walk, false, "walking") { goes = true; }

  Pose2 odometry;                ///< motion of the robot's ground frame in this cycle, as planned
  Vec2 velocity = Vec2::Zero();  ///< walked now [m/s]
  double turn = 0;               ///< [rad/s]
  double leftShare = 0.5;        ///< of the weight on the left foot, as planned
  WalkLimits limits;             ///< of what may be asked for
  /// Forward, sideways, turn [m/s, rad/s].
  Vec3 speed() const { return {velocity.x(), velocity.y(), turn}; }
  void stream(InStream* in, OutStream* out) override {
    MotionOutput::stream(in, out);
    STREAM("odometryPosition", odometry.position);
    STREAM("odometryHeading", odometry.heading);
    STREAM(velocity);
    STREAM(turn);
    STREAM(leftShare);
    STREAM("limitForward", limits.forward);
    STREAM("limitBackward", limits.backward);
    STREAM("limitSideways", limits.sideways);
    STREAM("limitTurn", limits.turn);
    STREAM("accelerationForward", limits.accelerationForward);
    STREAM("decelerationForward", limits.decelerationForward);
    STREAM("accelerationSideways", limits.accelerationSideways);
    STREAM("accelerationTurn", limits.accelerationTurn);
  }
};

}  // namespace plumbline
