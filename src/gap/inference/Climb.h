#pragma once
#include <vector>

#include "gap/inference/LinearSearch.h"
#include "gap/inference/SetSearch.h"

namespace plumbline::gap {

/// Causes that do nothing that the replay shows, by index. A cause at its bound can do nothing and still
/// change the replay: its kind is replayed in finer steps.
std::vector<std::size_t> idleCauses(const Replayer& replayer, const Explanation& causes);

/// The cause that a set needs least if all others keep their values, by index.
std::size_t leastNeeded(const Replayer& replayer, const Scored& set);

/// A set at its likeliest values (Fit.h, by the coarse replayer), less the causes that do nothing or that it
/// is better without. Derivatives of long strides, which propose sets, miss the narrow places where some
/// values are right.
Scored climbed(const SearchTools& tools, const Explanation& start, std::size_t kinds);

/// A set, and the set without each of its causes, fitted anew.
SetProposal withLessOne(const Replayer& replayer, Scored set, std::size_t kinds);

}  // namespace plumbline::gap
