#include "gap/diagnosis/FindingOf.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "gap/diagnosis/Probability.h"
#include "math/WilsonInterval.h"

namespace plumbline::gap {

namespace {

constexpr double rivalShare = 0.01;  // probability that is worth a word
constexpr double z = 1.96;           // of 95 %

/// Commands are lost by chance, so the rate differs from the share that was lost.
void addChance(const Evaluator& fine, Finding& finding) {
  double found = 0;
  for (const auto& cycles : fine.lostCycles()) found += static_cast<double>(std::ranges::count(cycles, 1));
  const double rate = finding.cause.value;
  // Of all cycles in which a loss would have shown.
  const auto [lower, upper] = rate > 0 ? wilsonInterval(found, found / rate) : wilsonInterval(0, 0);
  finding.lower = std::max(0.0, rate - std::hypot(rate - finding.lower, rate - lower));
  finding.upper =
      std::min(finding.cause.effect->upper, rate + std::hypot(finding.upper - rate, upper - rate));
}

}  // namespace

Finding findingOf(std::size_t i, const Explanation& found, const std::vector<FittedCause>& choices,
                  Evaluator& fine, const GapMeter& meter, const Diagnosis& result) {
  Finding finding;
  finding.cause = found[i];
  fine.setBase(without(found, i));
  const double gapWithout = meter.under(fine);
  const Fit fit = fine.with(finding.cause);
  // Curvature of the sum of squares in the share of the cause that is there.
  const double spread = fit.change > 0 ? z * std::sqrt(correlation / fit.change) : 1;
  const Effect& effect = *finding.cause.effect;
  const double strength = effect.strengthOf(finding.cause.value);
  // A limit is never higher than none.
  finding.lower = effect.valueAt(strength * (effect.reciprocal ? std::max(0.0, 1 - spread) : 1 - spread));
  finding.upper = effect.valueAt(strength * (1 + spread));
  if (finding.lower > finding.upper) std::swap(finding.lower, finding.upper);
  if (effect.decoded) addChance(fine, finding);
  fine.setBase({finding.cause});
  const double gapAlone = meter.under(fine);
  const double whole = std::max(1e-9, result.gap.before - result.gap.floor);
  finding.closedAlone = std::clamp((result.gap.before - gapAlone) / whole, 0.0, 1.0);
  finding.closedLast = std::clamp((gapWithout - result.gap.after) / whole, 0.0, 1.0);

  const std::vector<double> shares = probabilities(choices, result.left);
  for (std::size_t c = 0; c < shares.size(); ++c) {
    const double probability = result.knownProbability * shares[c];
    if (choices[c].cause.sameKind(finding.cause)) {
      finding.probability = probability;
    } else if (probability > rivalShare) {
      finding.rivals.push_back({choices[c].cause, probability});
    }
  }
  return finding;
}

}  // namespace plumbline::gap
