#include "gap/diagnosis/LossDecoder.h"

#include <algorithm>
#include <cmath>
#include <memory>
#include <utility>

#include "gap/replay/Playback.h"

namespace plumbline::gap {

namespace {

constexpr std::size_t mostSurvivors = 512;  // for time and memory: those of 39 cycles
constexpr double mostUnseen = 4;            // losses that a guess has paid for and that do not show yet

/// Of guesses that differ in so many cycles: a dozen of 6, most of the pairs of losses among more.
std::size_t survivorsOf(std::size_t detectionCycles) {
  return std::min(mostSurvivors, detectionCycles * detectionCycles / 3);
}

/// What may have happened up to now, and how well it explains what was measured.
struct Guess {
  Playback playback;
  std::vector<std::uint8_t> lost;
  std::size_t arrived = 0;  ///< the last cycle whose command came
  double cost = 0;

  Guess(const Plant& plant, const Trial& trial) : playback(plant, trial, {}), lost(trial.cycles(), 0) {
    playback.settle();
    playback.lose(&lost);
  }
  Guess(const Guess& other)
      : playback(other.playback), lost(other.lost), arrived(other.arrived), cost(other.cost) {
    playback.lose(&lost);
  }
  Guess& operator=(const Guess&) = delete;

  bool agreesWith(const Guess& other, std::size_t cycle, std::size_t detectionCycles) const {
    const auto from = static_cast<std::ptrdiff_t>(cycle < detectionCycles ? 0 : cycle + 1 - detectionCycles);
    return std::equal(lost.begin() + from, lost.begin() + static_cast<std::ptrdiff_t>(cycle) + 1,
                      other.lost.begin() + from);
  }
};

/// Whether another cycle's command would do as well.
bool sameCommand(const Trial& trial, std::size_t a, std::size_t b) {
  return std::ranges::none_of(trial.command, [&](const std::vector<double>& command) {
    return !command.empty() && std::isfinite(command[a]) && std::isfinite(command[b]) &&
           command[a] != command[b];
  });
}

class Decoder {
public:
  Decoder(const Evidence& evidence, std::size_t t, double price, std::size_t detectionCycles)
      : evidence_(evidence),
        t_(t),
        trial_(evidence.trials()[t]),
        price_(price),
        detectionCycles_(detectionCycles) {}

  std::vector<std::uint8_t> decode(const Plant& plant) {
    guesses_.push_back(std::make_unique<Guess>(plant, trial_));
    for (std::size_t k = 0; k < trial_.cycles(); ++k) {
      branch(k);
      std::size_t values = 0;  // as many whatever was lost
      for (const auto& guess : guesses_) {
        const std::vector<Playback::Shown>& shown = guess->playback.play(k);
        guess->cost += squares(shown);
        values = shown.size();
      }
      compared_ += static_cast<double>(values);
      select(k);
    }
    return std::move(guesses_.front()->lost);
  }

private:
  /// Each guess once more, with this cycle lost where that can be seen.
  void branch(std::size_t cycle) {
    const std::size_t before = guesses_.size();
    for (std::size_t i = 0; i < before; ++i) {
      if (cycle > 0 && !sameCommand(trial_, guesses_[i]->arrived, cycle)) {
        guesses_.push_back(std::make_unique<Guess>(*guesses_[i]));
        guesses_.back()->lost[cycle] = 1;
        guesses_.back()->cost += price_;
      }
      guesses_[i]->arrived = cycle;
    }
  }

  double squares(const std::vector<Playback::Shown>& shown) const {
    double sum = 0;
    for (const auto& [signal, cycle, value] : shown) {
      const double w = evidence_.weights(t_, signal)[cycle];
      if (!(w > 0)) continue;
      // One that ran away is out.
      const double r = std::isfinite(value) ? trial_.signals[signal].values[cycle] - value : 1e3;
      sum += w * r * r;
    }
    return sum;
  }

  /// The best of those that agree in their last cycles; of these the best. One that is far behind would not
  /// catch up.
  void select(std::size_t cycle) {
    std::stable_sort(guesses_.begin(), guesses_.end(),
                     [](const auto& a, const auto& b) { return a->cost < b->cost; });
    std::vector<std::unique_ptr<Guess>> kept;
    // With a model that leaves more than the noise, guesses differ by more, too.
    const double best = guesses_.front()->cost, left = compared_ > 0 ? std::max(1.0, best / compared_) : 1;
    const double farthest = best + mostUnseen * left * price_;
    for (auto& guess : guesses_) {
      if (kept.size() == survivorsOf(detectionCycles_) || guess->cost > farthest) break;
      if (std::ranges::none_of(
              kept, [&](const auto& other) { return guess->agreesWith(*other, cycle, detectionCycles_); }))
        kept.push_back(std::move(guess));
    }
    guesses_ = std::move(kept);
  }

  const Evidence& evidence_;
  const std::size_t t_;
  const Trial& trial_;
  const double price_;
  const std::size_t detectionCycles_;
  double compared_ = 0;  ///< values up to now, in each guess
  std::vector<std::unique_ptr<Guess>> guesses_;
};

}  // namespace

std::vector<std::uint8_t> decodeLosses(const Plant& plant, const Evidence& evidence, std::size_t trial,
                                       double price, std::size_t detectionCycles) {
  return Decoder(evidence, trial, price, detectionCycles).decode(plant);
}

}  // namespace plumbline::gap
