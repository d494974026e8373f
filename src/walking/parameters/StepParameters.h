#pragma once
#include "math/Types.h"
#include "parameters/Parameter.h"

namespace plumbline::walking {

struct StepParameters {
  PARAMETERS(StepParameters)
  PARAMETER(double, duration, 0.18, "s", Range(0.08, 1), "of one step in the reference", "blends")
  PARAMETER(double, minDuration, 0.12, "s", Range(0.04, 1), "of the shortest step", "blends")
  PARAMETER(double, maxDuration, 0.30, "s", Range(0.08, 2), "of the longest step", "blends")
  PARAMETER(double, maxForward, 0.10, "m", Range(0.01, 0.4), "swing target before the centre of mass",
            "blends")
  PARAMETER(double, maxBackward, 0.08, "m", Range(0.01, 0.4), "swing target behind the centre of mass",
            "blends")
  PARAMETER(double, maxOutward, 0.14, "m", Range(0.05, 0.4), "swing target sideways of the centre of mass",
            "blends")
  PARAMETER(double, minFeetDistance, 0.09, "m", Range(0.08, 0.3),
            "least distance of the soles' centres: the feet do not cross", "blends")
  PARAMETER(double, height, 0.02, "m", Range(0.001, 0.1), "of the swing foot", "blends")
  PARAMETER(double, swingStart, 0, "", Range(0, 0.5),
            "share of the step before the swing foot moves over the ground", "blends")
  PARAMETER(double, swingEnd, 1, "", Range(0.51, 1), "share of the step when the swing foot has arrived",
            "blends")
  PARAMETER(double, swingSmoothness, 0.5, "", Range(0, 1),
            "0: constant speed over the ground, 1: from rest to rest", "blends")
  PARAMETER(double, swingSteepness, 1.5, "", Range(0.5, 3),
            "of lifting and lowering: 1 a sine arch, 2 from rest to rest", "blends")
  PARAMETER(double, swingPitch, 0, "rad", Range(-0.5, 0.5), "of the swing foot when highest, toes down",
            "blends")
};

/// The pendulum that steps are planned with.
struct PendulumParameters {
  PARAMETERS(PendulumParameters)
  PARAMETER(double, pendulumHeight, 0.25, "m", Range(0.05, 1), "height of the centre of mass over the ground",
            "blends")
  PARAMETER(double, lateralHeightOffset, 0, "m", Range(-0.3, 0.5),
            "added to the height for the motion sideways", "blends")
  PARAMETER(double, copForward, 0, "m", Range(-0.06, 0.06),
            "centre of pressure of the supporting sole, before its centre", "blends")
  PARAMETER(double, copOutward, 0, "m", Range(-0.04, 0.04),
            "centre of pressure of the supporting sole, to the outside", "blends")

  /// Heights for the motion forward and sideways [m].
  Vec2 heights() const { return {pendulumHeight, pendulumHeight + lateralHeightOffset}; }
  /// Centre of pressure of a carrying foot, to the outside [m].
  Vec2 pressure() const { return {copForward, copOutward}; }
};

/// The kick in a step.
struct KickParameters {
  PARAMETERS(KickParameters)
  PARAMETER(double, duration, 0.24, "s", Range(0.08, 1), "of the step that kicks")
  PARAMETER(double, back, 0.04, "m", Range(0, 0.2), "distance by which the foot is drawn back")
  PARAMETER(double, forward, 0.09, "m", Range(0, 0.3), "distance by which the foot is thrown forward")
};

}  // namespace plumbline::walking
