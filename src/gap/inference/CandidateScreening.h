#pragma once
#include <functional>
#include <optional>
#include <vector>

#include "gap/inference/Density.h"
#include "gap/inference/Likelihood.h"

namespace plumbline::gap {

/// A cause that would explain some of what is left.
struct Proposal {
  Cause cause;
  double gain = 0;  ///< of log density, to first order
};

struct ScreeningOptions {
  std::function<void(double share)> progress = {};
  /// What is replayed instead of a start, or nothing; null: each start.
  std::function<std::optional<Cause>(const Cause& start)> startFor = {};
};

/// Each kind of cause (effect, place, variant) at its starting values, replayed once under the nominal model.
/// Its change (the sensitivity) then shows, without any further replay, what it would gain in addition to any
/// other set, in any of the groups: the projection of the residual on the sensitivity.
class CandidateScreening {
public:
  /// Kinds whose chains have nothing to gain (MostToGain, under these shares) are not replayed; of long
  /// recordings only some windows are.
  CandidateScreening(const Replayer& replayer, const Shares& shares, const ScreeningOptions& options = {});

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
    std::vector<char> looked;  ///< flags of the trials that it was replayed in
    std::vector<Change> changes;
  };
  struct Left;     ///< what a base leaves in the cells
  struct Guessed;  ///< what a start would gain there, scales held
  Guessed guess(const Start& start, const Left& left) const;
  Guessed rate(const Start& start, const Left& left) const;
  double gainOf(const Start& start, const Left& left, double share) const;
  /// looked: flags of the trials that were replayed.
  std::vector<Change> changesOf(const Groups& groups, const Residuals& nominal, const Residuals& with,
                                const std::vector<char>& looked) const;
  Left leftOf(const Groups& groups, const Residuals& residuals, const Shares& shares) const;
  struct Worth;  ///< what is replayed of a kind
  void replayStarts(const Replayer& replayer, const Residuals& nominal, const std::vector<Worth>& worth,
                    const ScreeningOptions& options);
  struct Rated {
    std::size_t start;
    double gain;
  };
  std::vector<Rated> bestOfKinds(const Left& left, const std::function<bool(const Start&)>& wanted) const;
  void replayElsewhere(const Replayer& replayer, const Residuals& nominal, const Shares& shares);
  void replayFurtherStrengths(const Replayer& replayer, const Residuals& nominal, const Shares& shares);

  std::vector<char> looked_;        ///< per trial: any start is looked at there
  std::vector<char> onFeet_;        ///< per trial: free base
  std::vector<std::size_t> every_;  ///< per trial: cycles between those that are looked at
  std::size_t kinds_ = 0;
  std::vector<Start> starts_;
};

}  // namespace plumbline::gap
