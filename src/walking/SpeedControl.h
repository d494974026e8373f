#pragma once
#include "math/Types.h"
#include "walking/WalkParameters.h"

namespace plumbline::walking {

/// The speed that the walk aims at now: follows what is asked for within the limits of speed and
/// acceleration.
class SpeedControl {
public:
  void reset() {
    velocity_.setZero();
    turn_ = 0;
  }
  /// A cycle of dt [s]. goal, turn: asked for [m/s, rad/s]; p: the parameters at the present speed; calm: the
  /// share of the goal that the torso's deviation leaves, 0 .. 1.
  void update(Vec2 goal, double goalTurn, const WalkParameters& p, double calm, double dt);

  const Vec2& velocity() const { return velocity_; }  ///< [m/s]
  double turn() const { return turn_; }               ///< [rad/s]

private:
  Vec2 velocity_ = Vec2::Zero();
  double turn_ = 0;
};

}  // namespace plumbline::walking
