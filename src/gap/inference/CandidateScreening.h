#pragma once
#include <vector>

#include "gap/inference/Density.h"

namespace plumbline::gap {

/// A cause that would explain some of what is left.
struct Proposal {
  Cause cause;
  double gain = 0;  ///< of log density, to first order
};

/// Each kind of cause (effect, place, variant) at its starting values, replayed once under the nominal model.
/// What it changes (its sensitivity) then tells, without any further replay, what it would gain beside any
/// other set: the projection of the residual on the sensitivity.
class CandidateScreening {
public:
  /// Kinds whose chains have nothing to gain (scales at their noise, under these shares) are not replayed.
  CandidateScreening(const Replayer& replayer, const Shares& shares);

  /// How many kinds are possible at all on this robot with these recordings.
  std::size_t numKinds() const { return kinds; }
  /// The best start of each kind that gains, best kind first, at most so many.
  std::vector<Proposal> propose(const Explanation& base, const Shares& shares, std::size_t most) const;
  /// What a cause with this strength gains beside the base, to first order.
  std::size_t numStarts() const { return starts.size(); }

private:
  struct Change {
    std::size_t cell;
    std::vector<float> values;  ///< thinned
  };
  struct Start {
    Cause cause;
    std::vector<Change> changes;
  };
  double gainOf(const Start& start, const std::vector<std::vector<double>>& left,
                const std::vector<double>& scales, const std::vector<double>& densities, const Shares& shares,
                double& share) const;
  std::size_t thinning(const Cell& cell) const;

  const Replayer& replayer;
  std::size_t kinds = 0;
  std::vector<Start> starts;
};

}  // namespace plumbline::gap
