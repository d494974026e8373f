#pragma once
#include <optional>
#include <string>
#include <vector>

#include "gap/diagnosis/Evaluator.h"

namespace plumbline::gap {

/// The gap beyond noise in units of noise, of the worst channel in any run: name and size. floatingBase: only
/// runs on a floating base (true), or only on a fixed base (false).
struct WorstGap {
  double size = 0;
  std::string signal;
};
WorstGap worstGap(const Evaluator& evaluator, std::optional<bool> floatingBase = {});

/// The gap beyond noise of the worst channel in runs on the feet, in units of noise: the value below which
/// four fifths of the half-seconds stay. A foot that slips a moment too late changes the rest of its run. 0
/// without such runs.
double gapOnFloatingBase(const Evaluator& evaluator);

/// The gap beyond noise of the worst channel in any run with a fixed base, in units of noise. For a joint
/// with a sticking cause (Effect::sticks) in the base, or friction in the robot's file, it is taken over all
/// runs without the worst 3 % of their half-seconds.
double gapOnFixedBase(const Evaluator& evaluator);

/// Whether joints on a fixed base deviate about as far as on the feet: those recordings show the cause.
bool fixedBaseDecides(const Evaluator& evaluator);

/// The mean residual of an inertial sensor over all runs with a fixed base, in units of its noise: the
/// largest of any channel. Nothing moves there, so only the sensor itself can cause it.
WorstGap worstRestOffset(const Evaluator& evaluator);

/// Size of the gap as a root mean square in units of each signal's own noise, on blocks that were not used
/// for the fit. It counts the channels with a gap under the base with which it was constructed (all if none
/// has a gap).
class GapMeter {
public:
  explicit GapMeter(const Evaluator& nominal);
  double under(const Evaluator& evaluator) const;

private:
  std::vector<std::vector<bool>> counted_;  ///< per trial and signal
};

}  // namespace plumbline::gap
