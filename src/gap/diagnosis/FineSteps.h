#pragma once
#include "gap/diagnosis/Evidence.h"

namespace plumbline::gap {

/// Steps of the integrator with which nominal replays have converged: halving them changes no channel of a
/// run with a fixed base by more than 0.38 of its noise. For a NAO these are the defaults of ReplayOptions;
/// for stiffer robots they are shorter, down to an eighth.
ReplayOptions fineSteps(const Evidence& evidence, int jobs);

}  // namespace plumbline::gap
