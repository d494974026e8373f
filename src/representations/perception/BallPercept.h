#pragma once
#include "framework/Representation.h"
#include "math/Types.h"

namespace plumbline {

/// The ball of this image relative to the robot on the ground: origin below the torso, x the robot's heading
/// [m].
REPRESENTATION(BallPercept)
class BallPercept : public BallPerceptBase {
public:
  bool seen = false;
  Vec2 position = Vec2::Zero();
  double height = 0;  ///< of its centre above the ground [m]
  void stream(InStream* in, OutStream* out) override {
    STREAM(seen);
    STREAM(position);
    STREAM(height);
  }
};

}  // namespace plumbline
