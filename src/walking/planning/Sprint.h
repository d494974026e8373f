#pragma once
#include "walking/planning/SpeedLimits.h"

namespace plumbline::walking {

/// Where a sprint, a walk faster than the omnidirectional limits in one direction, is.
enum class SprintState {
  none,       ///< any mixture is walked
  preparing,  ///< a sprint is asked for: to the omnidirectional limit in its direction alone
  running,    ///< to full speed and at it
  braking,    ///< back to the omnidirectional limit
  settling    ///< there, straight on for a while
};

/// What the transitions depend on.
struct SprintConditions {
  bool asked = false;    ///< a sprint is wanted: none and preparing: for long enough; running: still
  bool ready = false;    ///< the walk is at the omnidirectional limit of the direction, and straight
  bool slow = false;     ///< not faster than that limit
  bool settled = false;  ///< slow for long enough
};

/// The state that follows. A cycle may pass through several: the caller goes on until it stays.
SprintState nextSprintState(SprintState state, const SprintConditions& conditions);

/// The target speed for a request: within the omnidirectional limits, or a sprint. A sprint always continues
/// to its full speed or back, because no walk between is known to be safe.
class Sprint {
public:
  /// A cycle of dt [s]. wish: asked for; now: the speed walked.
  Vec3 target(const Vec3& wish, const Vec3& now, const WalkParameters& p, double dt);

  SprintState state() const { return state_; }
  bool active() const { return axis_ >= 0; }
  /// In which it goes: 0 forward, 1 sideways, 2 turning; -1: no sprint.
  int axis() const { return axis_; }
  /// Acceleration along the axis: between the omnidirectional limit and full speed a sprint's own.
  double acceleration(double usual, const Vec3& now, const WalkParameters& p) const;

private:
  Vec3 slower(const Vec3& wish, const Vec3& now, const WalkParameters& p, double dt);
  Vec3 along(const Vec3& wish, const Vec3& now, const WalkParameters& p, double dt);

  SprintState state_ = SprintState::none;
  int axis_ = -1;
  double full_ = 0;      ///< speed of the sprint, with its sign
  double settled_ = 0;   ///< at the omnidirectional limit since the sprint [s]
  int wished_ = -1;      ///< axis that could be sprinted in, and
  double patience_ = 0;  ///< for how long this has been asked for [s]
};

}  // namespace plumbline::walking
