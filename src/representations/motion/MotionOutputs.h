#pragma once
#include "framework/Representation.h"
#include "math/Pose2.h"
#include "representations/motion/JointRequest.h"

namespace plumbline {

REPRESENTATION(WalkingEngineOutput)
class WalkingEngineOutput : public WalkingEngineOutputBase {
public:
  JointTargets targets;
  Pose2 odometry;                ///< motion of the robot's ground frame in this cycle, as planned
  bool standing = true;          ///< safe to leave the walk
  Vec2 velocity = Vec2::Zero();  ///< walked now [m/s]
  double turn = 0;               ///< [rad/s]
  void stream(InStream* in, OutStream* out) override {
    STREAM(targets);
    STREAM("odometryPosition", odometry.position);
    STREAM("odometryHeading", odometry.heading);
    STREAM(standing);
    STREAM(velocity);
    STREAM(turn);
  }
};

REPRESENTATION(SpecialActionsOutput)
class SpecialActionsOutput : public SpecialActionsOutputBase {
public:
  JointTargets targets;
  bool finished = true;
  void stream(InStream* in, OutStream* out) override {
    STREAM(targets);
    STREAM(finished);
  }
};

REPRESENTATION(KickMotionOutput)
class KickMotionOutput : public KickMotionOutputBase {
public:
  JointTargets targets;
  bool finished = true;
  void stream(InStream* in, OutStream* out) override {
    STREAM(targets);
    STREAM(finished);
  }
};

REPRESENTATION(StandOutput)
class StandOutput : public StandOutputBase {
public:
  JointTargets targets;
  void stream(InStream* in, OutStream* out) override { STREAM(targets); }
};

/// All joints slack.
REPRESENTATION(DeadMotionOutput)
class DeadMotionOutput : public DeadMotionOutputBase {
public:
  JointTargets targets;
  void stream(InStream* in, OutStream* out) override { STREAM(targets); }
};

/// Head angles wanted [rad].
REPRESENTATION(HeadMotionRequest)
class HeadMotionRequest : public HeadMotionRequestBase {
public:
  double yaw = 0;
  double pitch = 0;
  void stream(InStream* in, OutStream* out) override {
    STREAM(yaw);
    STREAM(pitch);
  }
};

}  // namespace plumbline
