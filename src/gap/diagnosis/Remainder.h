#pragma once
#include "gap/diagnosis/Evaluator.h"

namespace plumbline::gap {

/// Gap beyond noise of the worst channel, in units of its noise, that may remain: no further cause is looked
/// for.
constexpr double unexplained = 1.3;

/// What an evaluator's base leaves, in runs with a held base and on the feet, against what may remain.
class Remainder {
public:
  /// worstBefore: gap beyond noise of the worst channel without any cause, in units of its noise.
  Remainder(const Evaluator& evaluator, double worstBefore);

  /// Over what another engine may do otherwise: above 1, the causes found are not the whole of it.
  double unaccounted() const;
  double unaccountedHeld() const;
  double unaccountedOnFeet() const;
  /// What a further cause could be looked for in.
  double size() const;
  /// Whether so little is left of a large gap that it may be what the effects found do otherwise in reality.
  bool little() const;
  /// Whether it is below a multiple of what no other set of causes is tried for.
  bool mayRemain(double times = 1) const;
  /// On the feet, where replays take minutes, what contacts may do otherwise in another engine is only looked
  /// through for sensors, which need none.
  bool onlyOfSensors() const;

private:
  double held, onFeet, before;
};

}  // namespace plumbline::gap
