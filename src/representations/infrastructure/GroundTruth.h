#pragma once
#include "framework/Representation.h"
#include "math/Pose2.h"
#include "math/Types.h"

namespace plumbline {

/// The true state, for evaluation only; in the team's frame (opponent goal at +x).
REPRESENTATION(GroundTruth)
class GroundTruth : public GroundTruthBase {
public:
  bool valid = false;
  Pose3 T_field_torso = Pose3::Identity();  ///< of this robot
  Vec3 ball = Vec3::Zero();                 ///< [m]
  void stream(InStream* in, OutStream* out) override {
    STREAM(valid);
    STREAM(T_field_torso);
    STREAM(ball);
  }
};

}  // namespace plumbline
