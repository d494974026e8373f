#pragma once
#include <vector>

#include "gap/blind/BlindScore.h"

namespace plumbline::gap {

/// What answers say beyond the answer for the same recordings without a planted cause (BlindCase::reference).
/// A real robot has causes of its own, which are neither credit nor fault. A cause that both answers name is
/// left out if its strength differs by less than a quarter; else its value is the difference (factors are
/// divided). A cause that the reference has and the answer lacks counts as found where it cancels the planted
/// one within a quarter. An answer that is left with nothing says `none`; `unknown` counts only if the
/// reference says something else. Of a cause that moved against the sign of the planted one, the effect
/// becomes "SIGN:EFFECT", which is never right. Throws std::runtime_error: the set has no reference or its
/// answer is missing.
std::vector<BlindAnswer> beyondReference(const BlindSet& set, std::vector<BlindAnswer> answers,
                                         const Mechanism& robot);

}  // namespace plumbline::gap
