#include "gap/settings/SettingsEvaluator.h"

#include <cmath>
#include <limits>
#include <stdexcept>

#include "framework/Parallel.h"

namespace plumbline::gap {

SettingsEvaluator::SettingsEvaluator(const TraceEvidence& evidence, const SimulatorSetup& nominal, int jobs)
    : data_(evidence), jobs_(jobs), own_(typicalError(evidence.ownErrors(nominal, jobs))) {}

SetupFit SettingsEvaluator::of(const SimulatorSetup& setup, Part part, int onlyType) const {
  const std::vector<TraceWindow>& windows = data_.windows();
  SetupFit fit;
  fit.scores.assign(windows.size(), std::numeric_limits<double>::quiet_NaN());
  fit.errors.resize(windows.size());
  parallel(windows.size(), jobs_, [&](std::size_t w) {
    const TraceWindow& window = windows[w];
    if (part != Part::all && window.leftOut != (part == Part::leftOut)) return;
    if (part == Part::look && w % 5 != 0) return;
    if (onlyType >= 0 && data_.traces()[window.trace].robotType != onlyType) return;
    try {
      fit.errors[w] = data_.errorOf(window, setup);
    } catch (const std::runtime_error&) {
      fit.errors[w].fill(std::numeric_limits<double>::infinity());
    }
    double score = 0;
    for (std::size_t s = 0; s < numTraceSignals; ++s)
      score += 0.5 * std::log1p(fit.errors[w][s] / (own_[s] * own_[s]));
    // A simulation that goes to pieces explains nothing.
    fit.scores[w] = std::isfinite(score) ? score : 1e3;
  });
  return fit;
}

double SettingsEvaluator::sum(const SetupFit& fit) const {
  double total = 0;
  for (const double score : fit.scores)
    if (!std::isnan(score)) total += score;
  return total;
}

std::vector<double> SettingsEvaluator::gains(const SetupFit& a, const SetupFit& b) const {
  std::vector<double> result;
  std::size_t last = std::numeric_limits<std::size_t>::max();
  for (std::size_t w = 0; w < a.scores.size(); ++w) {
    const TraceWindow& window = data_.windows()[w];
    if (!window.leftOut) continue;
    if (window.trace != last) result.push_back(0);
    last = window.trace;
    result.back() += a.scores[w] - b.scores[w];
  }
  return result;
}

double SettingsEvaluator::gap(const std::vector<WindowError>& errors) const {
  std::vector<WindowError> left;
  for (std::size_t w = 0; w < errors.size(); ++w)
    if (data_.windows()[w].leftOut) left.push_back(errors[w]);
  const WindowError typical = typicalError(left);
  double sum = 0;
  for (std::size_t s = 0; s < numTraceSignals; ++s) sum += typical[s] * typical[s] / (own_[s] * own_[s]);
  return std::sqrt(sum / numTraceSignals);
}

}  // namespace plumbline::gap
