#pragma once
#include <functional>
#include <vector>

#include "gap/inference/CandidateScreening.h"
#include "gap/inference/Score.h"

namespace plumbline::gap {

struct BeamOptions {
  std::size_t mostCauses = 8;
  std::size_t width = 2;                    ///< sets that are extended
  std::size_t proposals = 5;                ///< causes that each is extended by
  int fitSteps = 4, lastSteps = 12;         ///< of each set's fit, and of the answer's
  LeaveOut lastLeaveOut = LeaveOut::refit;  ///< of the answer
  std::function<void(double share)> progress = {};
  /// Of these groups, or of more; null: the search makes its own.
  const CandidateScreening* screening = nullptr;
};

/// What a search came to: sets, the best first.
struct BeamResult {
  std::vector<Scored> sets;
  std::vector<Scored> lessOne;  ///< the best without each of its causes in turn
  std::size_t kinds = 0;
};

/// Searches for the set of causes with the best score. Moves: add a cause, drop one, put another in its
/// place, build it another way (variant), have all joints share it. Fits are made under the shares of what
/// the best set so far leaves.
BeamResult searchSets(const Replayer& replayer, const BeamOptions& options);

}  // namespace plumbline::gap
