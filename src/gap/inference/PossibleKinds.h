#pragma once
#include <vector>

#include "gap/diagnosis/Explanation.h"
#include "gap/inference/Groups.h"

namespace plumbline::gap {

/// Every kind of cause (effect, place, variant) that recordings of this sort can show on this robot, in the
/// library's order. Lost commands are not among them: they are decoded. The causes' values are 0.
std::vector<Cause> possibleKinds(const Groups& groups, const Mechanism& robot);

}  // namespace plumbline::gap
