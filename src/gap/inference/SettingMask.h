#pragma once
#include <string>
#include <vector>

#include "gap/inference/Replayer.h"

namespace plumbline::gap {

/// The recordings (Trial::recording) that the groups hold, each once, in their order.
std::vector<std::string> recordingsOf(const Groups& groups);

/// Minus the log prior of which recordings causes are inactive in (Cause::inactiveIn). The share of
/// recordings that lack a setting may be anything. So the prior that just these k of n lack it is
/// 1 / ((n + 1) C(n, k)). A cause that is active in all costs nothing.
double priceOfMasks(const Explanation& causes, const std::vector<std::string>& recordings);

/// The causes as they are expected in a recording that was not seen: those that are inactive in more than
/// half of the recordings are left out, and the others are active.
Explanation expectedElsewhere(Explanation causes, const std::vector<std::string>& recordings);

/// The same causes and values, each setting (Effect::setting) inactive in the recordings that are likelier
/// without it, if that gains more than it costs (priceOfMasks).
Explanation withLikeliestMasks(const Replayer& replayer, Explanation causes);

}  // namespace plumbline::gap
