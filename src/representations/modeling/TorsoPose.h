#pragma once
#include "framework/Representation.h"
#include "math/Types.h"

namespace plumbline {

/// The torso above the ground: origin on the ground below the torso's centre, x the robot's heading, z up
/// [m].
REPRESENTATION(TorsoPose)
class TorsoPose : public TorsoPoseBase {
public:
  Pose3 T_ground_torso = Pose3::Identity();
  bool valid = false;  ///< false while the robot lies or hangs: the height is then a guess
  void stream(InStream* in, OutStream* out) override {
    STREAM(T_ground_torso);
    STREAM(valid);
  }
};

}  // namespace plumbline
