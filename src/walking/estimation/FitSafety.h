#pragma once
#include <span>

#include "walking/estimation/ObservedStep.h"
#include "walking/planning/ReferenceTrajectory.h"

namespace plumbline::walking {

/// How far fitted parameters would change the walk. Steps of one kind of walking do not determine all of the
/// ten parameters. A set that predicts them well may still plan another walk at other speeds, or the same one
/// with the feet at other places. Only a nearly unchanged walk is safe.
class FitSafety {
public:
  /// The gait of these steps.
  explicit FitSafety(std::span<const ObservedStep> steps);

  /// Greatest change of the reference trajectory on the spot, at 0.2 m/s forward and backward and at the
  /// speed of the steps; 1: as much as is safe.
  double change(const ModelParameters& parameters) const;

private:
  ReferenceTrajectory walk(double speed, const ModelParameters& parameters) const;

  PlainPendulum pendulum_;
  double duration_ = 0.2, feetDistance_ = 0.11, speed_ = 0;
};

}  // namespace plumbline::walking
