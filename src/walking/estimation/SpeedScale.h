#pragma once
#include <algorithm>

#include "math/Types.h"

namespace plumbline::walking {

/// How much faster than planned the robot walks, learnt while it walks at one speed: the slope of the speed
/// observed over the speed planned, forward, sideways and turning each, by least squares with forgetting.
class SpeedScale {
public:
  /// Adds a cycle of dt [s] of a walk at the planned speed `aimed`, with the observed speed [m/s, m/s,
  /// rad/s]. average: walking time after which an observation counts for a third [s]; 0: learns nothing.
  void update(const Vec3& aimed, const Vec3& observed, double average, double dt) {
    steady_ = (aimed - before_).norm() < 1e-6 ? steady_ + dt : 0;
    before_ = aimed;
    if (average <= 0 || steady_ < settling || aimed.isZero()) return;
    const Vec3 at = planned(aimed);
    const double kept = std::max(0.0, 1 - dt / average);
    for (int i = 0; i < 3; ++i) {
      if (at[i] == 0) continue;
      products_[i] = kept * products_[i] + dt * at[i] * observed[i];
      squares_[i] = kept * squares_[i] + dt * at[i] * at[i];
      const double prior = knownSpeed[i] * knownSpeed[i];
      scale_[i] = std::clamp((products_[i] + prior) / (squares_[i] + prior), 1 / maxScale, maxScale);
    }
  }

  /// What has to be planned for this speed.
  Vec3 planned(const Vec3& aimed) const { return aimed.cwiseQuotient(scale_); }

private:
  static constexpr double settling = 0.6;   ///< after a change of speed: a step or two, and the delays [s]
  static constexpr double maxScale = 1.25;  ///< and its inverse is the least
  /// As if a second had been walked at these speeds with a scale of 1 [m/s, m/s, rad/s].
  static constexpr double knownSpeed[] = {0.1, 0.1, 0.4};

  Vec3 before_ = Vec3::Zero(), scale_ = Vec3::Ones(), products_ = Vec3::Zero(), squares_ = Vec3::Zero();
  double steady_ = 0;  ///< for how long the speed has been the same [s]
};

}  // namespace plumbline::walking
