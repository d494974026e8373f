#pragma once
#include "math/Types.h"
#include "walking/WalkParameters.h"

namespace plumbline::walking {

/// The speed that the walk aims at now: follows what is asked for within the limits of speed and
/// acceleration. Any mixture of directions is walked within an ellipsoid of the speeds that may be mixed
/// (mixForward ..); more, up to maxForward .., in one direction at a time: only when little else is asked
/// for, has been for a while, and that direction already walks at its speed in mixtures. Such a sprint always
/// passes through to its full speed or back, since no walk is known to be safe between.
class SpeedControl {
public:
  void reset() { *this = {}; }
  /// In a cycle in which the robot still stands: its first step already goes forward or backward at
  /// startSpeed, if so much is asked for.
  void begin(const Vec2& goal, const WalkParameters& p);
  /// A cycle of dt [s]. goal, turn: asked for [m/s, rad/s]; p: the parameters at the present speed; calm: the
  /// share of the goal that the torso's deviation leaves, 0 .. 1.
  void update(const Vec2& goal, double turn, const WalkParameters& p, double calm, double dt);

  Vec2 velocity() const { return now.head<2>(); }  ///< [m/s]
  double turn() const { return now.z(); }          ///< [rad/s]
  /// Of the forward velocity while it comes nearer to zero, mean over about a step; else 0 [m/s^2].
  double braking() const { return acceleration_ * now.x() < 0 ? acceleration_ : 0.0; }
  bool sprinting() const { return axis >= 0; }

private:
  Vec3 feasible(const Vec3& wish, const WalkParameters& p, double dt);
  int sprintAxis(const Vec3& wish, const WalkParameters& p) const;
  Vec3 sprint(const Vec3& wish, const WalkParameters& p, double dt);
  double sprintRate(double usual, const WalkParameters& p) const;
  static Vec3 straight(const Vec3& wish, const Vec3& mix, int axis, double share);

  Vec3 now = Vec3::Zero();  ///< forward, sideways, turn
  double acceleration_ = 0;
  int axis = -1;         ///< in which the robot sprints
  bool falling = false;  ///< the sprint is coming to its end
  double full = 0;       ///< speed of the sprint, with its sign
  double settled = 0;    ///< at the speed of mixtures since the sprint [s]
  int wished = -1;       ///< axis that could be sprinted in, and
  double patience = 0;   ///< for how long this has been asked for [s]
};

}  // namespace plumbline::walking
