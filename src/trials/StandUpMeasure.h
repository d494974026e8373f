#pragma once
#include "trials/StandUpOptions.h"
#include "trials/TaskOutcome.h"

namespace plumbline {

/// Judges a try of the task standUp, for whoever plays it: formula 3.1 of Seekircher 2015 with the opposite
/// sign. milliseconds: of the motion; error: angles between torso and upright after it, summed over cycles
/// [rad]; up: AfterMotion::upright in the end. These are the figures, too.
inline TaskOutcome standUpOutcome(const StandUpOptions& options, double milliseconds, double error, bool up) {
  TaskOutcome outcome;
  outcome.cost = error + options.weight * milliseconds;
  outcome.figures = {{"time", milliseconds}, {"error", error}, {"up", up ? 1.0 : 0.0}};
  return outcome;
}

}  // namespace plumbline
