#pragma once
#include <cmath>

#include "math/Types.h"

namespace plumbline::walking {

/// Knows a fall that can no longer be stopped, from the torso's angles and turn rates. A body that tips over
/// the edge of its feet is a pendulum turned upside down. Its angle plus `lead` times its rate grows and does
/// not come back once it is over the edge. With lead = sqrt(h/g) that sum is the pendulum's diverging part.
struct FallGuardParameters {
  double roll = 0, pitch = 0;  ///< of the sum, beyond which it is a fall [rad]; 0: never
  double lead = 0.16;          ///< [s]
  double patience = 0.03;      ///< it must last for so long [s]
};

class FallGuard {
public:
  /// One cycle: torso against gravity (roll, pitch) [rad], its rates [rad/s]. True from the cycle on in which
  /// a fall is known, until the robot has been upright and at rest for half a second.
  bool update(const Vec2& torsoAngles, const Vec2& rates, double dt, const FallGuardParameters& p) {
    const Vec2 sum = torsoAngles + p.lead * rates;
    const bool beyond = over(sum.x(), torsoAngles.x(), p.roll) || over(sum.y(), torsoAngles.y(), p.pitch);
    lasting_ = beyond ? lasting_ + dt : 0;
    if (beyond && lasting_ >= p.patience - 1e-9) falling_ = true;
    calm_ = torsoAngles.norm() < 0.2 && rates.norm() < 0.3 ? calm_ + dt : 0;
    if (falling_ && calm_ > 0.5) reset();
    return falling_;
  }
  bool falling() const { return falling_; }
  void reset() {
    falling_ = false;
    lasting_ = calm_ = 0;
  }

private:
  /// Far over, and already to that side: a fast turn back to upright is no fall.
  static bool over(double sum, double angle, double limit) {
    return limit > 0 && std::abs(sum) > limit && sum * angle > 0;
  }
  bool falling_ = false;
  double lasting_ = 0, calm_ = 0;
};

}  // namespace plumbline::walking
