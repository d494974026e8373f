#include "gap/inference/SettingSearch.h"

#include <algorithm>
#include <cmath>
#include <map>

#include "gap/inference/Density.h"
#include "gap/inference/Strengths.h"

namespace plumbline::gap {

namespace {

constexpr double spacing = 1.15;      // of strengths that are replayed
constexpr double clear = 0.2;         // share of a recording's squares that is gained or lost
constexpr double nearlyAsGood = 0.9;  // of a single joint's gain, from which on all joints share a setting

/// Strengths over the range of the starts of a search.
std::vector<double> strengthsOf(const Mechanism& robot, const Cause& kind) {
  double least = HUGE_VAL, most = 0;
  const double scale = kind.effect->scaleAt(robot, kind.place);
  for (const double start : kind.effect->starts) {
    const double strength = std::abs(kind.effect->strengthOf(start * scale));
    least = std::min(least, strength);
    most = std::max(most, strength);
  }
  const auto count = static_cast<std::size_t>(std::lround(std::log(most / least) / std::log(spacing)));
  std::vector<double> strengths(count + 1, least);
  for (std::size_t k = 1; k < strengths.size(); ++k) strengths[k] = strengths[k - 1] * spacing;
  return strengths;
}

using PerRecording = std::map<std::string, double>;
using Squares = std::map<int, PerRecording>;  ///< of positions, per motor

PerRecording summed(const Squares& of) {
  PerRecording sums;
  for (const auto& [motor, perRecording] : of)
    for (const auto& [recording, square] : perRecording) sums[recording] += square;
  return sums;
}

struct Rated {
  Cause cause;
  double gain = 0;  ///< share of the squares that the base leaves, summed over recordings
  std::vector<std::pair<double, std::string>> worse = {};  ///< by how much, and in which recordings
};

class SettingScan {
public:
  SettingScan(const Replayer& replayer, const Explanation& base)
      : replayer_(replayer), base_(base), before_(squaresOf(base)), whole_(summed(before_)) {}

  /// The best of an effect, of all its places, strengths and forms; without an effect if none gains.
  Rated best(const Effect& effect) const {
    Rated shared, single;
    for (int variant = 0; variant < effect.numVariants(); ++variant) look(effect, variant, shared, single);
    return shared.gain >= nearlyAsGood * single.gain ? shared : single;
  }

private:
  void look(const Effect& effect, int variant, Rated& shared, Rated& single) const {
    const Mechanism& robot = replayer_.mechanism();
    std::vector<Cause> joints, everywhere;
    for (const Place& place : placesOf(effect, robot)) {
      if (effect.canBeAt && !effect.canBeAt(robot, place)) continue;
      if (place.site == Site::joint) joints.push_back({&effect, place, 0, variant});
      if (place.site == Site::everywhere && place.index < 0)
        everywhere.push_back({&effect, place, 0, variant});
    }
    if (joints.empty()) return;
    Explanation rest = base_;
    std::erase_if(rest, [&](const Cause& cause) { return cause.effect == &effect; });
    const Squares without = rest.size() < base_.size() ? squaresOf(rest) : before_;
    const std::size_t count = strengthsOf(robot, joints.front()).size();
    const auto take = [](Rated rated, Rated& into) {
      if (rated.gain > into.gain) into = std::move(rated);
    };
    for (std::size_t k = 0; k < count; ++k) {
      Explanation tried = rest;
      for (Cause& joint : joints) tried.push_back(joint = withStrength(robot, joint, strengthAt(joint, k)));
      const Squares with = squaresOf(tried);
      for (const Cause& joint : joints)
        if (const int motor = robot.motorOf(joint.place.index); with.contains(motor))
          take(rated(joint, with.at(motor), without.at(motor), before_.at(motor)), single);
      for (const Cause& all : everywhere)
        take(rated(withStrength(robot, all, strengthAt(all, k)), summed(with), summed(without), whole_),
             shared);
    }
  }

  double strengthAt(const Cause& kind, std::size_t k) const {
    const std::vector<double> strengths = strengthsOf(replayer_.mechanism(), kind);
    return strengths[std::min(k, strengths.size() - 1)];
  }

  Squares squaresOf(const Explanation& causes) const {
    const Groups& groups = replayer_.groups();
    const Residuals residuals = replayer_.residuals(causes);
    Squares squares;
    for (const Cell& cell : groups.cells()) {
      const Trial& trial = groups.trials()[cell.trial];
      const Signal& signal = trial.signals[cell.signal];
      if (signal.kind != SignalKind::position) continue;
      double& sum = squares[replayer_.mechanism().motorOf(signal.joint)][trial.recording];
      for (const double r : residualsOf(cell, residuals))
        if (std::isfinite(r)) sum += r * r;
    }
    return squares;
  }

  /// With the recordings that are clearly worse with it, if any is better.
  Rated rated(const Cause& cause, const PerRecording& with, const PerRecording& without,
              const PerRecording& before) const {
    Rated rated{cause};
    std::size_t better = 0;
    for (const auto& [recording, square] : with) {
      const double rest = without.at(recording), whole = whole_.at(recording);
      if (whole > 0) rated.gain += (before.at(recording) - std::min(square, rest)) / whole;
      better += square < rest ? 1 : 0;
      const double loss = whole > 0 ? (square - rest) / whole : 0;
      if (loss > clear) rated.worse.emplace_back(loss, recording);
    }
    return better > 0 ? rated : Rated{};
  }

  const Replayer& replayer_;
  const Explanation base_;
  const Squares before_;
  const PerRecording whole_;
};

}  // namespace

std::vector<Cause> proposedSettings(const Replayer& replayer, const Explanation& base, std::size_t most) {
  const SettingScan scan(replayer, base);
  std::vector<Rated> ratings;
  for (const Effect* effect : effects())
    if (effect->setting)
      if (Rated rated = scan.best(*effect); rated.gain > clear) ratings.push_back(std::move(rated));
  std::ranges::stable_sort(ratings, std::ranges::greater(), &Rated::gain);
  std::vector<Cause> proposed;
  for (Rated& rated : ratings) {
    // What a recording loses may be due to other values, so not all that lose have to be without it.
    std::ranges::stable_sort(rated.worse, std::ranges::greater(), [](const auto& of) { return of.first; });
    if (rated.worse.empty()) proposed.push_back(rated.cause);
    for (const auto& [loss, recording] : rated.worse) {
      rated.cause.inactiveIn.push_back(recording);
      std::ranges::sort(rated.cause.inactiveIn);
      proposed.push_back(rated.cause);
    }
  }
  if (proposed.size() > most) proposed.resize(most);
  return proposed;
}

}  // namespace plumbline::gap
