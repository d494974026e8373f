#pragma once
#include <vector>

#include "gap/settings/TraceEvidence.h"

namespace plumbline::gap {

/// A setup against the recordings: one score per window, lower is better.
struct SetupFit {
  std::vector<double> scores;  ///< NaN where not replayed
  std::vector<WindowError> errors;
};

/// Scores setups in units of the error of the nominal setup on its own windows.
class SettingsEvaluator {
public:
  SettingsEvaluator(const TraceEvidence& evidence, const SimulatorSetup& nominal, int jobs);

  enum class Part { look, fitting, leftOut, all };  ///< look: every fifth window for fitting
  SetupFit of(const SimulatorSetup& setup, Part part, int onlyType = -1) const;
  /// Sum over the windows that were replayed.
  double sum(const SetupFit& fit) const;
  /// Gain of b over a per left-out recording that has windows.
  std::vector<double> gains(const SetupFit& a, const SetupFit& b) const;
  /// Typical error over left-out windows, root mean square over the signals in units of unit().
  double gap(const std::vector<WindowError>& errors) const;
  const WindowError& unit() const { return own_; }

private:
  const TraceEvidence& data_;
  int jobs_;
  WindowError own_{};
};

}  // namespace plumbline::gap
