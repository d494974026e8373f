#include "walking/planning/StepLimits.h"

#include <algorithm>
#include <cmath>

namespace plumbline::walking {

StepLimits stepLimits(const WalkParameters& p, const LegKinematics& leg) {
  StepLimits limits;
  limits.forward = p.step.maxForward;
  limits.backward = p.step.maxBackward;
  limits.minOutward = p.step.minFeetDistance / 2;
  limits.maxOutward = p.step.maxOutward;
  limits.hipY = std::abs(leg.hip().y());
  // The ankle lies over the sole; a little is kept for the torso's own shift.
  const double drop = p.posture.hipHeight - leg.ankleHeight();
  limits.reach = 0.95 * std::sqrt(std::max(0.0, leg.maxReach() * leg.maxReach() - drop * drop));
  limits.restX = p.model.copForward;
  limits.calmRate = p.startStop.calmRate;
  limits.calmTime = p.startStop.calmTime;
  limits.minDuration = p.step.minDuration;
  limits.maxDuration = p.step.maxDuration;
  return limits;
}

}  // namespace plumbline::walking
