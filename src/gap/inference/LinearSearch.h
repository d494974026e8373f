#pragma once
#include <functional>

#include "gap/inference/Beam.h"
#include "gap/inference/CoefficientReplayer.h"

namespace plumbline::gap {

struct LinearSearchOptions {
  std::size_t mostCauses = 8;
  int rounds = 8;                 ///< of new derivatives, at most
  std::size_t mostSettled = 100;  ///< sets that are fitted to their end, those with the best scores
  /// Which causes of a fitted set do nothing, by index: they leave it, and the others are fitted again. Null:
  /// nobody looks.
  std::function<std::vector<std::size_t>(const Explanation&)> idleCauses = {};
  std::vector<CauseKind> configured =
      {};                  ///< kinds in addition to those of the replayer; no move takes one out
  Explanation start = {};  ///< where the search begins, of these kinds
  std::function<void(double share)> progress = {};
};

/// A set of causes that coefficients make likely, with the values that they give it, and the set without each
/// of its causes in turn. Scores are those of the coefficients; the values are as in Scored.
struct SetProposal {
  Scored set;
  std::vector<Scored> lessOne;
};

/// Sets of causes with the best scores by a replayer's coefficients, one for each number of causes from none
/// on. Moves (add a cause, drop one, put another in its place) are judged by derivatives at the set
/// itself. A set that is better by them is fitted by replays, and new derivatives are taken at it.
std::vector<SetProposal> proposedSets(CoefficientReplayer& replayer, const LinearSearchOptions& options);

}  // namespace plumbline::gap
