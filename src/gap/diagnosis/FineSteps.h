#pragma once
#include "gap/diagnosis/Evidence.h"

namespace plumbline::gap {

/// Steps of the integrator with which nominal replays are converged: halving them changes no channel of a run
/// with a held base by more than 0.38 of its noise. ReplayOptions' own for a NAO; shorter,
/// down to an eighth, for stiffer robots.
ReplayOptions fineSteps(const Evidence& evidence, int jobs);

}  // namespace plumbline::gap
