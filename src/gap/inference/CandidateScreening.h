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
/// Its change (the sensitivity) then shows, without any further replay, what it would gain in addition to any
/// other set, in any of the groups: the projection of the residual on the sensitivity.
class CandidateScreening {
public:
  /// Kinds whose chains have nothing to gain (scales at their noise, under these shares) are not replayed;
  /// of long recordings only some windows are. progress: share done.
  CandidateScreening(const Replayer& replayer, const Shares& shares,
                     const std::function<void(double)>& progress = {});

  /// How many kinds are possible at all on this robot with these recordings.
  std::size_t numKinds() const { return kinds_; }
  /// The best start of each kind that gains, best kind first, at most so many. within: the replayer of the
  /// groups that count, all or some of those that were screened.
  std::vector<Proposal> propose(const Replayer& within, const Explanation& base, const Shares& shares,
                                std::size_t most) const;
  std::size_t numStarts() const { return starts_.size(); }

private:
  /// What a start changes in a signal of a trial, at every n-th cycle.
  struct Change {
    std::size_t trial = 0, signal = 0;
    std::vector<float> values;
  };
  struct Start {
    Cause cause;
    std::vector<Change> changes;
  };
  struct Left;     ///< what a base leaves in the cells
  struct Guessed;  ///< what a start would gain there, scales held
  Guessed guess(const Start& start, const Left& left) const;
  double gainOf(const Start& start, const Left& left, double share) const;
  std::vector<Change> changesOf(const Groups& groups, const Residuals& nominal, const Residuals& with) const;
  Left leftOf(const Groups& groups, const Residuals& residuals, const Shares& shares) const;
  void replayStarts(const Replayer& replayer, const Residuals& nominal, const std::vector<Cause>& worth,
                    const std::function<void(double)>& progress);
  void replayFurtherStrengths(const Replayer& replayer, const Residuals& nominal, const Shares& shares);

  std::vector<char> looked_;        ///< per trial
  std::vector<std::size_t> every_;  ///< per trial: cycles between those that are looked at
  std::size_t kinds_ = 0;
  std::vector<Start> starts_;
};

}  // namespace plumbline::gap
