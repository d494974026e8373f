#include "gap/diagnosis/LostCycles.h"

#include <algorithm>
#include <cmath>

#include "framework/Parallel.h"
#include "gap/diagnosis/LossDecoder.h"
#include "gap/diagnosis/LossResponse.h"

namespace plumbline::gap {

namespace {

constexpr std::size_t reach = 4;  // cycles within which only one changes its mind in a round
constexpr int rounds = 8;
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
        lost_(trial_.cycles(), 0),
        gains_(trial_.cycles(), 0),
        seen_(trial_.cycles(), 0),
        offTime_(trial_.cycles(), 0) {
    // If a loss takes long to show, losses can imitate much else. Repeats that agree show that nothing was
    // lost, which saves the time.
    if (slow() && repeatsAgree(evidence_.trials())) return;
    lost_ = decodeLosses(plant_, evidence_, t_, price_, response_.detectionCycles);
    for (int round = 0; round < rounds; ++round) {
      tryAll();
      if (!changeBest()) break;
    }
  }

  std::vector<std::uint8_t> cycles() const { return lost_; }
  bool slow() const { return response_.detectionCycles > LossResponse::minDetection; }
  bool visible(std::size_t k) const { return seen_[k] >= visibleChange; }
  /// Whether a loss left the joint one cycle late, as far as the readings show.
  bool onTime(std::size_t k) const {
    return std::abs(offTime_[k]) < aboutOne + 2 / std::sqrt(std::max(1.0, seen_[k]));
  }

private:
  Prediction played(const std::vector<std::uint8_t>& cycles) const {
    ReplayOptions options;
    options.lostCycles = &cycles;
    return replay(plant_, trial_, options);
  }

  /// What turning each cycle's loss over would gain, given the others.
  void tryAll() {
    const Prediction base = played(lost_);
    // What two cycles that are tried in one replay change does not mix.
    for (std::size_t offset = 0; offset < response_.settlingCycles; ++offset) {
      std::vector<std::uint8_t> tried = lost_;
      for (std::size_t k = offset; k < tried.size(); k += response_.settlingCycles) tried[k] ^= 1;
      const Prediction other = played(tried);
      for (std::size_t k = offset; k < tried.size(); k += response_.settlingCycles) weigh(k, base, other);
    }
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
    seen_[k] = change;
    offTime_[k] = change > 0 ? along / change : 0;
    gains_[k] = gain - (lost_[k] ? 0 : price_);
  }

  /// Neighbours explain much of the same: only the best of them changes in a round.
  bool changeBest() {
    bool any = false;
    for (std::size_t k = 0; k < gains_.size(); ++k) {
      if (gains_[k] <= 0) continue;
      const std::size_t from = k >= reach ? k - reach : 0, to = std::min(k + reach + 1, gains_.size());
      bool best = true;
      for (std::size_t i = from; i < to; ++i)
        best = best && (gains_[i] < gains_[k] || i == k || (gains_[i] == gains_[k] && i > k));
      if (!best) continue;
      lost_[k] ^= 1;
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
  std::vector<std::uint8_t> lost_;
  std::vector<double> gains_, seen_;
  std::vector<double>
      offTime_;  ///< of a loss: cycles by which what it changes is less than the readings' want
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
