#pragma once
#include "walking/ReferenceTrajectory.h"

namespace plumbline::walking {

/// What the robot's body allows of a step; the swing foot in the frame of the centre of mass when it lands.
struct StepLimits {
  double forward = 0.1, backward = 0.08;  ///< before and behind [m]
  double minOutward = 0.045;              ///< the feet do not cross: half of their smallest distance [m]
  double maxOutward = 0.14;               ///< [m]
  double hipY = 0.055, reach = 0.2;       ///< foot at most this far from the point under the hip [m]
  double minDuration = 0.12, maxDuration = 0.3;  ///< of a whole step [s]
  double maxTurnRate = 2.5;                      ///< of the torso over the supporting foot [rad/s]
  double restX = 0;                  ///< centre of mass before the soles' centres when standing [m]
  Vec2 pressure = Vec2(0.05, 0.02);  ///< centre of pressure at most this far from a sole's centre [m]
};

/// Chooses actions with which a state comes as near to a reference trajectory as the body allows
/// (section 4.2.3).
class StepPlanner {
public:
  StepPlanner(const WalkModel& model, const StepLimits& limits) : model(model), limits(limits) {}
  void setLimits(const StepLimits& newLimits) { limits = newLimits; }

  /// The rest of the step in progress, which has lasted `elapsed` [s]: the time from the lateral velocity at
  /// its end, the target from the state after the step that follows.
  WalkAction step(const WalkState& state, double elapsed, const ReferenceTrajectory& reference) const;

  /// Double support for `duration`, after which `first` carries alone: the centre of pressure from the state
  /// after the first step.
  WalkAction start(const WalkState& state, double duration, Side first,
                   const ReferenceTrajectory& reference) const;

  /// Double support that brings the centre of mass to rest over the middle of the feet.
  WalkAction stand(const WalkState& state, double duration) const;

  /// Whether stand() can hold the robot if both feet carried from now on.
  bool canStand(const WalkState& state) const;

  /// Whether the capture point of a state on both feet is at most `margin` [m] outside the rectangle in which
  /// the pressure may be.
  bool canHold(const WalkState& state, double margin) const;

  /// The step target moved to where the body allows it; support: the carrying foot in the same frame.
  Pose2 limitTarget(const Pose2& target, const Pose2& support, Side swing) const;

private:
  double remainingTime(const WalkState& state, double elapsed, double turnRate, double nominal,
                       double lateralVelocity) const;
  Vec2 calmingPressure(const WalkState& state) const;
  Vec2 limitPressure(const WalkState& state, const Vec2& point, double share) const;

  const WalkModel& model;
  StepLimits limits;
};

}  // namespace plumbline::walking
