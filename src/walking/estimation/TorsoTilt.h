#pragma once
#include <algorithm>

#include "walking/estimation/WalkSensors.h"
#include "walking/parameters/WalkParameters.h"

namespace plumbline::walking {

/// How far the torso is off its planned and usual attitude, about x and y.
struct TorsoTilt {
  Vec2 angle = Vec2::Zero();   ///< when the coming command takes effect [rad]
  Vec2 rate = Vec2::Zero();    ///< [rad/s]
  Vec2 excess = Vec2::Zero();  ///< what of the deviation is more than tolerated [rad]

  /// lean: the planned pitch [rad].
  void update(const WalkSensors& sensors, double lean, const WalkParameters& p) {
    rate = sensors.gyro.head<2>();
    const Vec2 deviation = sensors.torsoAngles - Vec2(0, lean);
    // Every walk has its own mean lean, which is no error to correct (compare section 4.2.8).
    if (p.feedback.tiltWindow > 0)
      usual_ += (deviation - usual_) * std::min(1.0, sensors.dt / p.feedback.tiltWindow);
    const Vec2 tolerance = Vec2::Constant(p.feedback.tiltTolerance);
    excess = deviation - deviation.cwiseMax(-tolerance).cwiseMin(tolerance);
    angle = deviation - usual_ + p.feedback.delay * rate;
  }

private:
  Vec2 usual_ = Vec2::Zero();  ///< running mean of the deviation [rad]
};

}  // namespace plumbline::walking
