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
  /// How far the torso's x axis, seen from above, has turned since the start, counterclockwise, in (-pi, pi].
  /// By the gyroscope alone; R_start_torso = Rz(heading) * Ry(pitch) * Rx(roll).
  double heading = 0;
  void stream(InStream* in, OutStream* out) override {
    STREAM(roll);
    STREAM(pitch);
    STREAM(heading);
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
