#pragma once
#include <optional>
#include <string>
#include <vector>

#include "gap/diagnosis/Evaluator.h"

namespace plumbline::gap {

/// The gap beyond noise in units of noise, of the worst channel in any run: name and size. standing: of runs
/// on a floating base alone (true), or on a fixed base alone (false).
struct WorstGap {
  double size = 0;
  std::string signal;
};
WorstGap worstGap(const Evaluator& evaluator, std::optional<bool> standing = {});

/// The gap beyond noise in units of noise that four fifths of the half-seconds on the feet stay below, of the
/// worst channel: a foot that slips a moment too late changes the rest of its run. 0 without such runs.
double gapOnFloatingBase(const Evaluator& evaluator);

/// The gap beyond noise in units of noise with a fixed base, of the worst channel in any run; of a joint
/// where the base has a cause that sticks (Effect::sticks), over all runs but for the worst 3 % of their
/// half-seconds.
double gapOnFixedBase(const Evaluator& evaluator);

/// Whether joints on a fixed base deviate about as far as on the feet: those recordings show the cause.
bool fixedBaseDecides(const Evaluator& evaluator);

/// The mean residual of an inertial sensor over all runs with a fixed base, in units of its noise: the
/// largest of any channel. Nothing moves there, so nothing but the sensor itself can be off by it.
WorstGap worstRestOffset(const Evaluator& evaluator);

/// Size of the gap as a root mean square in units of each signal's own noise, on blocks that took no part in
/// the fit, over the channels that show something under the base that it was made with (all where none does).
class GapMeter {
public:
  explicit GapMeter(const Evaluator& nominal);
  double under(const Evaluator& evaluator) const;

private:
  std::vector<std::vector<bool>> counted_;  ///< per trial and signal
};

}  // namespace plumbline::gap
