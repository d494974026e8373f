#pragma once
#include <vector>

#include "gap/diagnosis/Evidence.h"

namespace plumbline::gap {

/// Evidence whose noise is what repeats differ by, unless they differ because commands were lost: that is a
/// cause to be found, not a floor, and the noise is then each channel's own and
/// a part of that.
Evidence evidenceOf(std::vector<Trial> trials, int jobs);

}  // namespace plumbline::gap
