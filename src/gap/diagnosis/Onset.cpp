#include "gap/diagnosis/Onset.h"

#include <algorithm>
#include <cmath>

#include "gap/replay/Replay.h"

namespace plumbline::gap {

namespace {

constexpr double minDeviation = 8;       // noises that count as having left
constexpr std::size_t inARow = 3;        // cycles
constexpr double soonest = 1;            // [s] of a run: what is off before that is off from the start
constexpr int bisections = 11;           // of three decades: to half a percent
constexpr double leastOfUpper = 0.0005;  // the smallest value that is tried

/// Cycles of one run from which on other values leave the base's.
class Departure {
public:
  Departure(const Evaluator& evaluator, const Cause& cause, std::size_t t)
      : evaluator_(evaluator), t_(t), trial_(evaluator.evidence().trials()[t]) {
    for (std::size_t s = 0; s < trial_.signals.size(); ++s) {
      const Signal& signal = trial_.signals[s];
      if (signal.kind == SignalKind::position &&
          (cause.place.site == Site::everywhere || signal.joint == cause.place.index))
        signals_.push_back(s);
    }
  }

  /// The first of a few cycles in a row; the number of cycles where they never do.
  std::size_t of(const std::vector<std::vector<double>>& values) const {
    std::size_t first = trial_.cycles();
    for (const std::size_t s : signals_) {
      const std::vector<double>&weights = evaluator_.evidence().weights(t_, s),
            &base = evaluator_.basePrediction(t_).values[s];
      std::size_t row = 0;
      for (std::size_t k = 0; k < std::min({first, values[s].size(), base.size()}); ++k) {
        const double d = values[s][k] - base[k];
        row = weights[k] * d * d > minDeviation * minDeviation ? row + 1 : 0;
        if (row == inARow) first = k + 1 - inARow;
      }
    }
    return first;
  }
  std::size_t measured() const {
    std::vector<std::vector<double>> values;
    for (const Signal& signal : trial_.signals) values.push_back(signal.values);
    return of(values);
  }

private:
  const Evaluator& evaluator_;
  const std::size_t t_;
  const Trial& trial_;
  std::vector<std::size_t> signals_;
};

/// The run with a fixed base in which the places of a cause are off most.
std::optional<std::size_t> runThatShowsMost(const Evaluator& evaluator, const Cause& cause) {
  std::optional<std::size_t> most;
  double worst = 0;
  const auto& trials = evaluator.evidence().trials();
  for (std::size_t t = 0; t < trials.size(); ++t)
    for (std::size_t s = 0; s < trials[t].signals.size(); ++s) {
      const Signal& signal = trials[t].signals[s];
      const bool there = cause.place.site == Site::everywhere || signal.joint == cause.place.index;
      if (trials[t].freeBase || signal.kind != SignalKind::position || !there) continue;
      if (!(evaluator.chi(t, s) > worst)) continue;
      worst = evaluator.chi(t, s);
      most = t;
    }
  return most;
}

}  // namespace

std::optional<Cause> causeByOnset(const Evaluator& evaluator, const Cause& start) {
  const std::optional<std::size_t> t = runThatShowsMost(evaluator, start);
  if (!t) return {};
  const Trial& trial = evaluator.evidence().trials()[*t];
  const Departure departure(evaluator, start, *t);
  const std::size_t wanted = departure.measured();
  if (wanted >= trial.cycles() || trial.time[wanted] - trial.time[0] < soonest) return {};
  ReplayOptions options;
  options.joints = evaluator.jointsTouched(start);
  Cause cause = start;
  const auto setsIn = [&](double value) {
    cause.value = value;
    Explanation causes = evaluator.base();
    causes.push_back(cause);
    return departure.of(replay(plantOf(trial, causes), trial, options).values);
  };
  const double upper = start.effect->boundsAt(evaluator.mechanism(), start.place).upper;
  double low = leastOfUpper * upper, high = upper;
  if (setsIn(high) > wanted || setsIn(low) <= wanted) return {};
  for (int i = 0; i < bisections; ++i) {
    const double middle = std::sqrt(low * high);
    (setsIn(middle) <= wanted ? high : low) = middle;
  }
  cause.value = high;
  return cause;
}

}  // namespace plumbline::gap
