#pragma once
#include <vector>

#include "gap/inference/Fit.h"

namespace plumbline::gap {

/// A set of causes with the one figure that it is judged by.
struct Scored {
  Fitted fitted;                     ///< to all groups
  std::vector<Explanation> without;  ///< per group: as fitted to the others
  std::vector<double> gain;          ///< per group: of log density over the nominal model, by these values
  double price = 0;                  ///< minus the logarithm of the set's prior probability

  const Explanation& causes() const { return fitted.causes; }
  double score() const;  ///< sum of gain, less price
};

/// Minus the log prior of so many causes out of so many kinds that are possible, all alike.
double priceOf(std::size_t causes, std::size_t kinds);

/// How the values without a group are found: by one Newton step from the fit to all (halved, or not taken,
/// where the other groups would be less likely), or by a new fit.
enum class LeaveOut { newtonStep, refit };

/// Fits the set to all groups under these shares, then leaves each group out in turn and replays it, free
/// from its beginning, with the values of the others (gainsOf). starts: per group, other values that its
/// refit may begin with; empty: none.
Scored score(const Replayer& replayer, const Shares& shares, const Explanation& start, std::size_t kinds,
             int mostSteps, LeaveOut how = LeaveOut::newtonStep, const std::vector<Explanation>& starts = {});

/// Shares under which two hypotheses are compared: of the mean of the two correlation times of what they
/// leave. The difference of two log scales has the variances of both. A scale at the noise is known, and has
/// none.
Shares sharesOfBoth(const Groups& groups, const Residuals& left, const Residuals& nominal);

/// What a set gains over the nominal model in each group, with the values that it has without the group.
/// Both count under sharesOfBoth (the set with its values of all groups), so a set has one score, whatever it
/// is compared with.
std::vector<double> gainsOf(const Replayer& replayer, const Explanation& fitted,
                            const std::vector<Explanation>& without);

}  // namespace plumbline::gap
