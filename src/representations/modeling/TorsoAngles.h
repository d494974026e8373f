#pragma once
#include "framework/Representation.h"
#include "math/Types.h"

namespace plumbline {

/// Estimated tilt of the torso: T_ground_torso = Ry(pitch) * Rx(roll), heading left out [rad].
REPRESENTATION(TorsoAngles)
class TorsoAngles : public TorsoAnglesBase {
public:
  double roll = 0;   ///< positive: leaning to the right
  double pitch = 0;  ///< positive: leaning forward
  void stream(InStream* in, OutStream* out) override {
    STREAM(roll);
    STREAM(pitch);
  }
};

/// The world's up direction in the torso frame, unit length.
REPRESENTATION(UprightVec)
class UprightVec : public UprightVecBase {
public:
  Vec3 up = Vec3::UnitZ();
  void stream(InStream* in, OutStream* out) override { STREAM(up); }
};

}  // namespace plumbline
