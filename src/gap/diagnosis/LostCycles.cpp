#include "gap/diagnosis/LostCycles.h"

#include <algorithm>
#include <cmath>

#include "gap/diagnosis/Parallel.h"

namespace plumbline::gap {

namespace {

constexpr std::size_t spacing =
    10;                           // cycles between two that are tried in one replay: a servo settles within
constexpr std::size_t reach = 4;  // cycles within which only one changes its mind in a round
constexpr int rounds = 8;
constexpr double cycleGain = 14;  // of the sum of squares: e^-7 by chance, in thousands of cycles
constexpr double visibleChange = 4 * cycleGain;
// Where single cycles leave a run this far off, losses are also moved, from one cycle to another near by.
constexpr double farOff = 150;  // square of a residual over noise
constexpr std::size_t leadIn = 8, tried = 16, aftermath = 60;  // cycles before, from there on, after
constexpr std::size_t near = 4;          // a run of lost cycles that is as long moves by one so
constexpr std::size_t fewStretches = 6;  // in more it is not for lost commands that a run is far off

/// Which commands one run lost, cycle by cycle.
class Listener {
public:
  Listener(const Evidence& evidence_, std::size_t t_, const Explanation& causes, int mendings)
      : evidence(evidence_),
        t(t_),
        trial(evidence_.trials()[t_]),
        plant(plantOf(*trial.robot, causes)),
        lost(trial.cycles(), 0),
        gains(trial.cycles(), 0),
        seen(trial.cycles(), 0) {
    double least = INFINITY;
    std::vector<std::uint8_t> best = lost;
    for (int round = 0; round < rounds; ++round) {
      const Prediction base = played(lost);
      const double squares = squaresOf(base);
      if (squares >= least) break;  // what neighbours each promised does not add up
      least = squares;
      best = lost;
      tryAll(base);
      if (!changeBest()) break;
    }
    if (squaresOf(played(lost)) > least) lost = best;
    for (int round = 0; round < mendings && mend(); ++round) continue;
  }

  std::vector<std::uint8_t> cycles() const { return lost; }
  bool visible(std::size_t k) const { return seen[k] >= visibleChange; }

private:
  Prediction played(const std::vector<std::uint8_t>& cycles) const {
    ReplayOptions options;
    options.lostCycles = &cycles;
    return replay(plant, trial, options);
  }

  /// What turning each cycle's loss over would gain, given the others.
  void tryAll(const Prediction& base) {
    for (std::size_t offset = 0; offset < spacing; ++offset) {
      std::vector<std::uint8_t> turnedOver = lost;
      for (std::size_t k = offset; k < turnedOver.size(); k += spacing) turnedOver[k] ^= 1;
      const Prediction other = played(turnedOver);
      for (std::size_t k = offset; k < turnedOver.size(); k += spacing) weigh(k, base, other);
    }
  }

  void weigh(std::size_t k, const Prediction& base, const Prediction& other) {
    double gain = 0, change = 0;
    forEachReading(base, k + 1, k + spacing, [&](std::size_t s, std::size_t i, double w, double r) {
      const double d = other.values[s][i] - base.values[s][i];
      gain += w * (2 * r * d - d * d);
      change += w * d * d;
    });
    seen[k] = change;
    gains[k] = gain - (lost[k] ? 0 : cycleGain);
  }

  /// Calls use(signal, cycle, weight, residual) for the joints' readings in cycles [from, to).
  template <class Use>
  void forEachReading(const Prediction& base, std::size_t from, std::size_t to, Use&& use) const {
    for (std::size_t s = 0; s < trial.signals.size(); ++s) {
      if (trial.signals[s].joint < 0 || base.values[s].empty()) continue;
      const auto& weights = evidence.weights(t, s);
      for (std::size_t i = from; i < std::min(to, trial.cycles()); ++i)
        if (weights[i] > 0 && std::isfinite(base.values[s][i]))
          use(s, i, weights[i], trial.signals[s].values[i] - base.values[s][i]);
    }
  }

  /// Squares over noise, and what the lost cycles cost.
  double squaresOf(const Prediction& base) const {
    double sum = cycleGain * static_cast<double>(std::ranges::count(lost, 1));
    forEachReading(base, 0, trial.cycles(), [&](auto, auto, double w, double r) { sum += w * r * r; });
    return sum;
  }

  /// First cycles of the stretches that are far off.
  std::vector<std::size_t> stretches(const Prediction& base) const {
    std::vector<std::uint8_t> far(trial.cycles(), 0);
    forEachReading(base, 0, trial.cycles(),
                   [&](auto, std::size_t i, double w, double r) { far[i] |= w * r * r > farOff; });
    std::vector<std::size_t> starts;
    for (std::size_t k = 0; k < far.size(); ++k)
      if (far[k] && (starts.empty() || k >= starts.back() + aftermath + leadIn)) starts.push_back(k);
    return starts;
  }

  /// Cycles of a run to turn over: one, or one that is lost and one near by that is not.
  using Move = std::vector<std::size_t>;

  /// Moves for a stretch that is far off from a cycle on.
  std::vector<Move> movesAt(std::size_t start) const {
    const std::size_t from = start - std::min(start, leadIn), to = std::min(from + tried, lost.size());
    std::vector<Move> moves;
    for (std::size_t a = from; a < to; ++a) {
      moves.push_back({a});
      for (std::size_t b = a + 1; b < std::min(to, a + near + 1); ++b)
        if (lost[a] != lost[b]) moves.push_back({a, b});
    }
    return moves;
  }

  /// What other lost cycles gain around a stretch.
  double gainAt(std::size_t start, const std::vector<std::uint8_t>& cycles, const Prediction& base,
                const Prediction& other) const {
    const std::size_t from = start - std::min(start, leadIn), to = std::min(start + aftermath, cycles.size());
    double gain = 0;
    forEachReading(base, from, to, [&](std::size_t s, std::size_t i, double w, double r) {
      const double d = other.values[s][i] - base.values[s][i];
      gain += w * (2 * r * d - d * d);
    });
    for (std::size_t k = from; k < to; ++k) gain -= cycleGain * (cycles[k] - lost[k]);
    return gain;
  }

  /// Makes the move that helps each stretch most, a replay for all stretches at a time; whether any did.
  bool mend() {
    const Prediction base = played(lost);
    const std::vector<std::size_t> starts = stretches(base);
    if (starts.size() > fewStretches) return false;
    std::vector<std::vector<Move>> moves;
    std::size_t count = 0;
    for (const std::size_t start : starts) {
      moves.push_back(movesAt(start));
      count = std::max(count, moves.back().size());
    }
    std::vector<double> most(starts.size(), 0);
    std::vector<Move> best(starts.size());
    for (std::size_t m = 0; m < count; ++m) {
      std::vector<std::uint8_t> cycles = lost;
      for (const auto& of : moves)
        if (m < of.size()) turnOver(of[m], cycles);
      const Prediction other = played(cycles);
      for (std::size_t n = 0; n < starts.size(); ++n) {
        if (m >= moves[n].size()) continue;
        const double gain = gainAt(starts[n], cycles, base, other);
        if (gain > most[n]) most[n] = gain, best[n] = moves[n][m];
      }
    }
    for (const Move& move : best) turnOver(move, lost);
    return std::ranges::any_of(best, [](const Move& move) { return !move.empty(); });
  }

  static void turnOver(const Move& move, std::vector<std::uint8_t>& cycles) {
    for (const std::size_t k : move) cycles[k] ^= 1;
  }

  /// Neighbours explain much of the same: only the best of them changes in a round.
  bool changeBest() {
    bool any = false;
    for (std::size_t k = 0; k < gains.size(); ++k) {
      if (gains[k] <= 0) continue;
      const std::size_t from = k >= reach ? k - reach : 0, to = std::min(k + reach + 1, gains.size());
      bool best = true;
      for (std::size_t i = from; i < to; ++i)
        best = best && (gains[i] < gains[k] || i == k || (gains[i] == gains[k] && i > k));
      if (!best) continue;
      lost[k] ^= 1;
      any = true;
    }
    return any;
  }

  const Evidence& evidence;
  const std::size_t t;
  const Trial& trial;
  const Plant plant;
  std::vector<std::uint8_t> lost;
  std::vector<double> gains, seen;
};

}  // namespace

LostCycles findLostCycles(const Evidence& evidence, const Explanation& causes, int jobs, int mendings) {
  LostCycles result;
  const std::size_t count = evidence.trials().size();
  result.cycles.resize(count);
  std::vector<std::size_t> found(count, 0), visible(count, 0);
  parallel(count, jobs, [&](std::size_t t) {
    if (evidence.trials()[t].freeBase) return;
    const Listener listener(evidence, t, causes, mendings);
    result.cycles[t] = listener.cycles();
    for (std::size_t k = 0; k < result.cycles[t].size(); ++k) {
      if (!listener.visible(k)) continue;
      ++visible[t];
      found[t] += result.cycles[t][k];
    }
  });
  std::size_t seen = 0;
  for (std::size_t t = 0; t < count; ++t) {
    result.found += found[t];
    seen += visible[t];
  }
  result.share = seen ? static_cast<double>(result.found) / static_cast<double>(seen) : 0;
  result.price = cycleGain * static_cast<double>(result.found) / 2;  // half of the blocks are for judging
  return result;
}

}  // namespace plumbline::gap
