#pragma once
#include "walking/estimation/TorsoTilt.h"
#include "walking/model/WalkState.h"

namespace plumbline::walking {

/// The walk state as step planning sees it: a share of the torso's tilt (feedback.stepForwardGain ..) is
/// motion of the pendulum about the foot.
inline WalkState perceivedState(WalkState state, const TorsoTilt& tilt, const WalkParameters& p) {
  const double h = p.model.pendulumHeight;
  const Vec2 gain(p.feedback.stepForwardGain, p.feedback.stepSidewaysGain);
  const Vec2 shift = gain.cwiseProduct(Vec2(tilt.angle.y(), -tilt.angle.x())) * h;
  for (Pose2& foot : state.foot) foot.position -= shift;
  state.velocity += gain.cwiseProduct(Vec2(tilt.rate.y(), -tilt.rate.x())) * h;
  return state;
}

}  // namespace plumbline::walking
