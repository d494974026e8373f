#pragma once
#include <optional>
#include <vector>

#include "gap/diagnosis/Evidence.h"
#include "gap/diagnosis/Explanation.h"

namespace plumbline::gap {

/// Evidence whose noise is what repeats differ by, unless they differ because commands were lost: that is a
/// cause to be found, not a floor. The noise is then what repeats differ by beside what lost commands
/// explain.
Evidence evidenceOf(std::vector<Trial> trials, int jobs);

/// The same for a robot that has these causes, beside which lost commands may show better; nothing where that
/// lowers the noise by less than a third: repeats differ by noise, or by something else.
std::optional<Evidence> evidenceBesideLosses(const Evidence& byRepeats, const Explanation& causes, int jobs);

}  // namespace plumbline::gap
