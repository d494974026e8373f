#include "gap/diagnosis/AcceptanceTest.h"

#include <algorithm>
#include <cmath>

namespace plumbline::gap {

namespace {

constexpr double leastVisible =
    0.7;                      // least change over noise, in some channel, of a cause that earns its place
constexpr double leastZ = 3;  // of the gain over blocks
constexpr double minSameSignShare = 0.75;  // of the gains' absolute values
constexpr double leastShare = 0.05;        // of what is unexplained
constexpr double directionsPerChannel = 2;
constexpr double lowerShare = 0.98, lowerWithin = 0.02;  // of the worst channel

/// The largest change of any channel in any run, in units of its noise: the present base compared with
/// earlier predictions.
double largestChange(const Evaluator& evaluator, const std::vector<Prediction>& before) {
  double most = 0;
  for (std::size_t t = 0; t < before.size(); ++t)
    most = std::max(most, evaluator.evidence().difference(t, before[t], evaluator.basePrediction(t)));
  return most;
}

/// Whether a gain on the blocks for judging does not come from a few of them by chance. It must be large
/// compared with its scatter over blocks, absolutely or relative to each block. If most blocks change little,
/// nearly all must change in one direction.
bool consistent(const Fit& before, const Fit& after) {
  double sum = 0, squares = 0, sizes = 0, share = 0, shareSquares = 0;
  for (std::size_t b = 0; b < before.squares.size(); ++b) {
    if (Evidence::forFitting(b)) continue;
    const double d = before.squares[b] - after.squares[b], whole = before.squares[b] + after.squares[b];
    const double part = whole > 0 ? d / whole : 0;
    sum += d;
    squares += d * d;
    sizes += std::abs(d);
    share += part;
    shareSquares += part * part;
  }
  return sum > 0 && (sum >= leastZ * std::sqrt(squares) || share >= leastZ * std::sqrt(shareSquares) ||
                     sum >= minSameSignShare * sizes);
}

}  // namespace

double excess(const Evaluator& evaluator) {
  const Evidence& data = evaluator.evidence();
  double n = 0;
  for (std::size_t t = 0; t < data.trials().size(); ++t)
    for (std::size_t s = 0; s < data.trials()[t].signals.size(); ++s)
      data.forEach(t, s, evaluator.basePrediction(t),
                   [&](std::size_t k, double, double) { n += !Evidence::forFitting(data.block(t, k)); });
  return evaluator.baseFit().judging - n;
}

double leftPerDirection(const Evaluator& evaluator) {
  double directions = 0;
  evaluator.forEachChannel([&](const Trial&, const Signal& signal, double) {
    if (Evidence::counts(signal)) directions += directionsPerChannel;
  });
  return directions > 0 ? std::max(0.0, excess(evaluator)) / directions : 0;
}

AcceptanceTest::AcceptanceTest(const Evaluator& evaluator)
    : fit_(evaluator.baseFit()), worst_(worstGap(evaluator)), unexplained_(excess(evaluator)) {
  worstHasCause_ = std::ranges::any_of(
      evaluator.base(), [&](const Cause& cause) { return worst_.signal == "pos." + cause.place.at; });
  for (std::size_t t = 0; t < evaluator.evidence().trials().size(); ++t)
    predictions_.push_back(evaluator.basePrediction(t));
}

/// Differences between engines add up over all channels, so a cause that shows in one channel may be judged
/// in that channel alone. This does not hold at a joint that has a cause: its remainder may be that cause,
/// acting differently in another engine.
bool AcceptanceTest::explainsWorst(const Evaluator& evaluator, double leastPart) const {
  if (worstHasCause_) return false;
  double left = 0;
  evaluator.forEachChannel([&](const Trial&, const Signal& signal, double chi) {
    if (signal.name == worst_.signal) left = std::max(left, chi - 1);
  });
  return left <= (1 - leastPart) * worst_.size * worst_.size;
}

bool AcceptanceTest::passes(const Evaluator& evaluator, double leastPart) const {
  const double gain = fit_.judging - evaluator.baseFit().judging;
  // Real robots have more than one thing missing: the worst channel may wait for the next cause.
  const bool lowers =
      worstGap(evaluator).size < lowerShare * worst_.size + lowerWithin || gain > leastShare * unexplained_;
  return lowers && gain >= leastGain &&
         (gain >= leastPart * unexplained_ || explainsWorst(evaluator, leastPart)) &&
         consistent(fit_, evaluator.baseFit()) && largestChange(evaluator, predictions_) >= leastVisible;
}

}  // namespace plumbline::gap
