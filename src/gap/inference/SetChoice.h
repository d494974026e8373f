#pragma once
#include <vector>

#include "gap/inference/Beam.h"
#include "gap/inference/LinearSearch.h"

namespace plumbline::gap {

/// Whether two sets have the same causes, whatever their values.
bool sameKinds(const Explanation& a, const Explanation& b);

const SetProposal& bestOf(const std::vector<SetProposal>& proposals);

/// The best of the answers by the one score, with the others, the sets also looked at, and the answer
/// without each of its causes.
BeamResult chosen(const std::vector<SetProposal>& answers, const std::vector<Scored>& alsoTried,
                  std::size_t kinds);

/// Adds proposals, scored by free replays and the price of so many kinds. Sets with a cause less are scored
/// where their set is the best so far, for no other can be chosen.
void addScored(const Replayer& replayer, std::vector<SetProposal> proposals, std::size_t kinds,
               std::vector<SetProposal>& answers);

}  // namespace plumbline::gap
