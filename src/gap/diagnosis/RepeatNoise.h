#pragma once
#include <vector>

#include "gap/diagnosis/Evidence.h"

namespace plumbline::gap {

/// Evidence whose noise is what repeats differ by, unless they differ because commands were lost: that is a
/// cause to be found, not a floor. The noise is then what repeats differ by beside what lost commands explain.
Evidence evidenceOf(std::vector<Trial> trials, int jobs);

}  // namespace plumbline::gap
