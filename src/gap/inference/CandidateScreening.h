#pragma once
#include <functional>
#include <vector>

#include "gap/inference/Density.h"
#include "gap/inference/Likelihood.h"

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
  /// Kinds whose chains have nothing to gain (scales at their noise, under these shares) are not replayed;
  /// of long recordings only some windows are. progress: share done.
  CandidateScreening(const Replayer& replayer, const Shares& shares,
                     const std::function<void(double)>& progress = {});

  /// How many kinds are possible at all on this robot with these recordings.
  std::size_t numKinds() const { return kinds; }
  /// The best start of each kind that gains, best kind first, at most so many.
  std::vector<Proposal> propose(const Explanation& base, const Shares& shares, std::size_t most) const;
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
  /// What a base leaves in a cell, thinned.
  struct Left {
    std::vector<double> values;
    Split parts;
    double scale = 0, density = 0;
  };
  /// share: of the start's strength that gains most.
  double gainOf(const Start& start, const std::vector<Left>& left, const Shares& shares, double& share) const;
  const Cell& cellOf(std::size_t c) const { return replayer.groups().cells()[c]; }
  std::size_t thinning(const Cell& cell) const;

  void replayStarts(const std::vector<Cause>& worth, const Residuals& nominal,
                    const std::function<void(double)>& progress);

  const Replayer& replayer;
  std::vector<char> looked;  ///< per trial
  std::size_t kinds = 0;
  std::vector<Start> starts;
};

}  // namespace plumbline::gap
