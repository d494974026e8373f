#pragma once
#include <functional>
#include <optional>
#include <vector>

#include "gap/inference/Density.h"

namespace plumbline::gap {

/// Starts of kinds of causes (Effect::starts) that recordings speak against: with one of these on top of the
/// replayer's base their log density falls by more than the logarithm of the number of kinds. So does a
/// stronger start of the same sign, which is not replayed then. Where changes are in proportion to the cause
/// and a weaker one would gain half of that logarithm, the weaker one takes the start's place.
class RuledOut {
public:
  /// kinds: those looked at, at any value. progress: share done.
  RuledOut(const Replayer& replayer, const std::vector<Cause>& kinds,
           const std::function<void(double)>& progress = {});

  /// What to look at instead of a start: itself, if nothing speaks against it; a weaker one; or none.
  std::optional<Cause> startFor(const Cause& start) const;

private:
  /// Of one form of a cause and one sign of its strength.
  struct Limit {
    Cause ruledOut;               ///< the weakest start that is
    std::optional<Cause> weaker;  ///< what takes its place
  };
  bool fallsBelow(const Cause& start) const;
  std::optional<Cause> weakerThan(const Cause& start) const;

  const Replayer& replayer_;
  Residuals left_;
  Shares shares_;
  std::vector<double> nominal_;  ///< log density per group
  double price_;
  std::vector<Limit> limits_;
};

}  // namespace plumbline::gap
