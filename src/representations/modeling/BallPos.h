#pragma once
#include "framework/Representation.h"
#include "math/Types.h"

namespace plumbline {

/// The ball as this robot tracks it; relative to the robot's ground frame [m, m/s].
REPRESENTATION(LocalBallPos)
class LocalBallPos : public LocalBallPosBase {
public:
  Vec2 position = Vec2::Zero();
  Vec2 velocity = Vec2::Zero();
  double deviation = 10;  ///< standard deviation of the position [m]
  double lastSeen = -1;   ///< FrameInfo time of the last percept that was used [s]
  bool valid = false;
  void stream(InStream* in, OutStream* out) override {
    STREAM(position);
    STREAM(velocity);
    STREAM(deviation);
    STREAM(lastSeen);
    STREAM(valid);
  }
};

/// The ball to act on, local belief and team combined: relative to the robot and on the field (team's frame).
REPRESENTATION(BallPos)
class BallPos : public BallPosBase {
public:
  Vec2 relative = Vec2::Zero();
  Vec2 relativeVelocity = Vec2::Zero();
  Vec2 field = Vec2::Zero();
  double age = 1e3;  ///< seconds since it was last seen
  bool valid = false;
  void stream(InStream* in, OutStream* out) override {
    STREAM(relative);
    STREAM(relativeVelocity);
    STREAM(field);
    STREAM(age);
    STREAM(valid);
  }
};

}  // namespace plumbline
