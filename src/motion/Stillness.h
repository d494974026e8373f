#pragma once
#include "math/Types.h"

namespace plumbline::motion {

/// Counts cycles in which the torso does not turn, for motions that wait until the robot has settled.
class Stillness {
public:
  /// gyro: turn rate of the torso [rad/s]. True once it has been small for some cycles.
  bool update(const Vec3& gyro);
  /// As update() said last.
  bool still() const { return cycles_ >= stillCycles; }

private:
  static constexpr double stillTurnRate = 0.3;  ///< [rad/s]
  static constexpr int stillCycles = 3;

  int cycles_ = 0;
};

}  // namespace plumbline::motion
