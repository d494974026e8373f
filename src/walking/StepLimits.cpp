#include "walking/StepLimits.h"

#include <algorithm>
#include <cmath>

namespace plumbline::walking {

StepLimits stepLimits(const WalkParameters& p, const LegKinematics& leg) {
  StepLimits limits;
  limits.forward = p.maxStepForward;
  limits.backward = p.maxStepBackward;
  limits.minOutward = p.minFeetDistance / 2;
  limits.maxOutward = p.maxStepOutward;
  limits.hipY = std::abs(leg.hip().y());
  // The ankle lies over the sole; a little is kept for the torso's own shift.
  const double drop = p.hipHeight - leg.ankleHeight();
  limits.reach = 0.95 * std::sqrt(std::max(0.0, leg.maxReach() * leg.maxReach() - drop * drop));
  limits.restX = p.copForward;
  limits.minDuration = p.minStepDuration;
  limits.maxDuration = p.maxStepDuration;
  return limits;
}

}  // namespace plumbline::walking
