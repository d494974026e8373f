#pragma once
#include "walking/planning/ReferenceTrajectory.h"
#include "walking/planning/StepLimits.h"

namespace plumbline::walking {

/// Chooses actions with which a state comes as near to a reference trajectory as the body allows
/// (section 4.2.3).
class StepPlanner {
public:
  StepPlanner(const WalkModel& model, const StepLimits& limits) : model_(model), limits_(limits) {}
  void setLimits(const StepLimits& newLimits) { limits_ = newLimits; }

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

  const WalkModel& model_;
  StepLimits limits_;
};

}  // namespace plumbline::walking
