#include "gap/diagnosis/LostCycles.h"

#include <algorithm>
#include <cmath>

#include "framework/Parallel.h"
#include "gap/diagnosis/LossDecoder.h"
#include "gap/diagnosis/LossResponse.h"

namespace plumbline::gap {

namespace {

constexpr std::size_t reach = 4;  // cycles within which only one changes its mind in a round, at first
constexpr int rounds = 16;
constexpr double visibleChange = 4 * LostCycles::surePrice;
constexpr double aboutOne = 0.3;     // cycles that a lost command is off from one cycle late
constexpr double leastOnTime = 0.6;  // share of the losses that are one cycle late; of another cause, a third

/// Which commands one run lost, cycle by cycle.
class LossesOfRun {
public:
  LossesOfRun(const Evidence& evidence, std::size_t t, const Explanation& causes, double price)
      : evidence_(evidence),
        t_(t),
        price_(price),
        trial_(evidence.trials()[t]),
        plant_(plantOf(trial_, causes)),
        response_(lossResponse(plant_, evidence, t, LostCycles::surePrice)),
        guess_(trial_.cycles()) {
    // If a loss takes long to show, losses can imitate much else. Repeats that agree show that nothing was
    // lost, which saves the time.
    if (slow() && repeatsAgree(evidence_.trials())) return;
    guess_.lost = decodeLosses(plant_, evidence_, t_, price_, response_.detectionCycles);
    tryAll();
    // Changes near each other can mix, and under a wrong model they never settle. Where together they make it
    // worse, only those that cannot mix are made.
    std::size_t apart = reach;
    for (int round = 1; round < rounds; ++round) {
      const Guess before = guess_;
      if (!changeBest(apart)) break;
      tryAll();
      if (guess_.cost < before.cost) continue;
      guess_ = before;
      if (apart >= response_.settlingCycles) break;
      apart = response_.settlingCycles;
    }
  }

  std::vector<std::uint8_t> cycles() const { return guess_.lost; }
  bool slow() const { return response_.detectionCycles > LossResponse::minDetection; }
  bool visible(std::size_t k) const { return guess_.seen[k] >= visibleChange; }
  /// Whether a loss left the joint one cycle late, as far as the readings show.
  bool onTime(std::size_t k) const {
    return std::abs(guess_.offTime[k]) < aboutOne + 2 / std::sqrt(std::max(1.0, guess_.seen[k]));
  }

private:
  /// What may have been lost, and per cycle what turning it over would gain and change.
  struct Guess {
    explicit Guess(std::size_t cycles)
        : lost(cycles, 0), gains(cycles, 0), seen(cycles, 0), offTime(cycles, 0) {}

    std::vector<std::uint8_t> lost;
    double cost = 0;  ///< squares over noise, and the losses' prices
    std::vector<double> gains, seen;
    std::vector<double>
        offTime;  ///< of a loss: cycles by which what it changes is less than the readings' want
  };

  Prediction played(const std::vector<std::uint8_t>& cycles) const {
    ReplayOptions options;
    options.lostCycles = &cycles;
    return replay(plant_, trial_, options);
  }

  /// What turning each cycle's loss over would gain, given the others.
  void tryAll() {
    const Prediction base = played(guess_.lost);
    guess_.cost = costOf(base);
    // What two cycles that are tried in one replay change does not mix.
    for (std::size_t offset = 0; offset < response_.settlingCycles; ++offset) {
      std::vector<std::uint8_t> tried = guess_.lost;
      for (std::size_t k = offset; k < tried.size(); k += response_.settlingCycles) tried[k] ^= 1;
      const Prediction other = played(tried);
      for (std::size_t k = offset; k < tried.size(); k += response_.settlingCycles) weigh(k, base, other);
    }
  }

  double costOf(const Prediction& base) const {
    double cost = price_ * static_cast<double>(std::ranges::count(guess_.lost, 1));
    for (std::size_t s = 0; s < trial_.signals.size(); ++s) {
      if (trial_.signals[s].joint < 0 || base.values[s].empty()) continue;
      const auto& weights = evidence_.weights(t_, s);
      for (std::size_t i = 0; i < trial_.cycles(); ++i) {
        const double r = trial_.signals[s].values[i] - base.values[s][i];
        if (weights[i] > 0 && std::isfinite(r)) cost += weights[i] * r * r;
      }
    }
    return cost;
  }

  void weigh(std::size_t k, const Prediction& base, const Prediction& other) {
    double gain = 0, change = 0, along = 0;
    for (std::size_t s = 0; s < trial_.signals.size(); ++s) {
      if (trial_.signals[s].joint < 0 || base.values[s].empty()) continue;
      const auto& weights = evidence_.weights(t_, s);
      for (std::size_t i = k + 1; i < std::min(k + response_.settlingCycles, trial_.cycles()); ++i) {
        if (weights[i] <= 0 || !std::isfinite(base.values[s][i])) continue;
        const double r = trial_.signals[s].values[i] - base.values[s][i];
        const double d = other.values[s][i] - base.values[s][i];
        gain += weights[i] * (2 * r * d - d * d);
        change += weights[i] * d * d;
        along += weights[i] * r * d;
      }
    }
    guess_.seen[k] = change;
    guess_.offTime[k] = change > 0 ? along / change : 0;
    // What was decoded as lost stays lost if its readings say so at all: else too few would be found.
    guess_.gains[k] = gain - (guess_.lost[k] ? 0 : price_);
  }

  /// Neighbours explain much of the same: only the best of them changes in a round.
  bool changeBest(std::size_t apart) {
    const std::vector<double>& gains = guess_.gains;
    bool any = false;
    for (std::size_t k = 0; k < gains.size(); ++k) {
      if (gains[k] <= 0) continue;
      const std::size_t from = k >= apart ? k - apart : 0, to = std::min(k + apart + 1, gains.size());
      bool best = true;
      for (std::size_t i = from; i < to; ++i)
        best = best && (gains[i] < gains[k] || i == k || (gains[i] == gains[k] && i > k));
      if (!best) continue;
      guess_.lost[k] ^= 1;
      any = true;
    }
    return any;
  }

  const Evidence& evidence_;
  const std::size_t t_;
  const double price_;
  const Trial& trial_;
  const Plant plant_;
  const LossResponse response_;
  Guess guess_;
};

}  // namespace

LostCycles findLostCycles(const Evidence& evidence, const Explanation& causes, int jobs, double price) {
  LostCycles result;
  const std::size_t count = evidence.trials().size();
  result.cycles.resize(count);
  result.foundIn.resize(count);
  result.seenIn.resize(count);
  std::vector<std::size_t> onTime(count, 0);
  std::vector<char> slow(count, 0);
  parallel(count, jobs, [&](std::size_t t) {
    if (evidence.trials()[t].freeBase) return;
    const LossesOfRun losses(evidence, t, causes, price);
    result.cycles[t] = losses.cycles();
    slow[t] = losses.slow();
    for (std::size_t k = 0; k < result.cycles[t].size(); ++k) {
      if (!losses.visible(k)) continue;
      ++result.seenIn[t];
      result.foundIn[t] += result.cycles[t][k];
      onTime[t] += result.cycles[t][k] && losses.onTime(k);
    }
  });
  std::size_t seen = 0, late = 0;
  for (std::size_t t = 0; t < count; ++t) {
    result.found += result.foundIn[t];
    seen += result.seenIn[t];
    late += onTime[t];
    result.slow = result.slow || slow[t];
  }
  result.share = seen ? static_cast<double>(result.found) / static_cast<double>(seen) : 0;
  // More than the effect can be is something else, too.
  const auto effect = std::ranges::find(effects(), true, &Effect::decoded);
  const double most = effect == effects().end() ? 1 : (*effect)->upper;
  if (static_cast<double>(late) < leastOnTime * static_cast<double>(result.found) || result.share > most) {
    for (auto& cycles : result.cycles) std::ranges::fill(cycles, std::uint8_t{0});
    result.foundIn.assign(count, 0);
    result.found = 0;
    result.share = 0;
  }
  result.price = price * static_cast<double>(result.found) / 2;  // half of the blocks are for judging
  return result;
}

}  // namespace plumbline::gap
