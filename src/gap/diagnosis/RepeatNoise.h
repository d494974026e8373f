#pragma once
#include <optional>
#include <vector>

#include "gap/diagnosis/Evidence.h"
#include "gap/diagnosis/Explanation.h"

namespace plumbline::gap {

/// Evidence whose noise is the difference between repeats. If repeats differ because commands were lost, this
/// is a cause to be found and not noise: the noise is then the difference that lost commands do not explain.
Evidence evidenceOf(std::vector<Trial> trials, int jobs);

/// The same for a robot with these causes, with which lost commands may show better. Nothing if that lowers
/// the noise by less than a third: then repeats differ by noise, or by something else.
std::optional<Evidence> evidenceWithoutLosses(const Evidence& byRepeats, const Explanation& causes, int jobs);

}  // namespace plumbline::gap
