#pragma once
#include "walking/planning/Sprint.h"

namespace plumbline::walking {

/// The target speed of the walk: follows the request within the limits of speed and acceleration. Any mixture
/// of directions is walked within an ellipsoid of the omnidirectional limits (speed.omniForward ..). More, up
/// to speed.maxForward .., is allowed in one direction at a time (Sprint): only if the request has had little
/// else for a while, and that direction is already at its limit.
class SpeedControl {
public:
  void reset() { *this = {}; }
  /// In a cycle in which the robot still stands: its first step already goes forward or backward at
  /// startStop.speed, if so much is asked for.
  void begin(const Vec2& goal, const WalkParameters& p);
  /// A cycle of dt [s]. goal, turn: asked for [m/s, rad/s]; p: the parameters at the present speed; calm: the
  /// share of the goal that the torso's deviation leaves, 0 .. 1.
  void update(const Vec2& goal, double turn, const WalkParameters& p, double calm, double dt);

  Vec2 velocity() const { return now_.head<2>(); }  ///< [m/s]
  double turn() const { return now_.z(); }          ///< [rad/s]
  const Vec3& all() const { return now_; }          ///< forward, sideways, turn [m/s, rad/s]
  /// Of the forward velocity while it comes nearer to zero, mean over about a step; else 0 [m/s^2].
  double braking() const { return acceleration_ * now_.x() < 0 ? acceleration_ : 0.0; }
  bool sprinting() const { return sprint_.active(); }

private:
  Vec3 now_ = Vec3::Zero();  ///< forward, sideways, turn
  double acceleration_ = 0;
  Sprint sprint_;
};

}  // namespace plumbline::walking
