#include "gap/inference/SettingSearch.h"

#include <algorithm>
#include <cmath>
#include <map>

#include "gap/inference/Density.h"
#include "gap/inference/Strengths.h"

namespace plumbline::gap {

namespace {

constexpr double spacing = 1.15;      // of strengths that are replayed
constexpr double clearShare = 0.2;    // of a recording's squares that is gained or lost
constexpr double nearlyAsGood = 0.9;  // of a single joint's gain, from which on all joints share a setting

/// How many strengths span the range of the starts of a search.
std::size_t numStrengths(const Mechanism& robot, const Cause& kind) {
  const double scale = kind.effect->scaleAt(robot, kind.place);
  double most = 0;
  for (const double start : kind.effect->starts)
    most = std::max(most, std::abs(kind.effect->strengthOf(start * scale)));
  return 1 +
         static_cast<std::size_t>(std::lround(std::log(most / leastStart(robot, kind)) / std::log(spacing)));
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
      : replayer_(replayer), base_(base), before_(squaresWith(base)), whole_(summed(before_)) {}

  /// The best of an effect, of all its places, strengths and forms; without an effect if none gains.
  Rated best(const Effect& effect) const {
    Rated shared, single;
    for (int variant = 0; variant < effect.numVariants(); ++variant) look(effect, variant, shared, single);
    return shared.gain >= nearlyAsGood * single.gain ? shared : single;
  }

private:
  void look(const Effect& effect, int variant, Rated& shared, Rated& single) const {
    const Mechanism& robot = replayer_.mechanism();
    struct Tried {
      Cause cause;
      double strength;
    };
    std::vector<Tried> joints, everywhere;
    for (const Place& place : placesOf(effect, robot)) {
      if (effect.canBeAt && !effect.canBeAt(robot, place)) continue;
      const Cause kind{&effect, place, 0, variant};
      if (place.site == Site::joint) joints.push_back({kind, leastStart(robot, kind)});
      if (place.site == Site::everywhere && place.index < 0)
        everywhere.push_back({kind, leastStart(robot, kind)});
    }
    if (joints.empty()) return;
    Explanation rest = base_;
    std::erase_if(rest, [&](const Cause& cause) { return cause.effect == &effect; });
    const Squares without = rest.size() < base_.size() ? squaresWith(rest) : before_;
    const auto take = [](Rated rated, Rated& into) {
      if (rated.gain > into.gain) into = std::move(rated);
    };
    const std::size_t count = numStrengths(robot, joints.front().cause);
    for (std::size_t k = 0; k < count; ++k) {
      Explanation tried = rest;
      for (Tried& joint : joints)
        tried.push_back(joint.cause = withStrength(robot, joint.cause, joint.strength));
      const Squares with = squaresWith(tried);
      for (Tried& joint : joints) {
        if (const int motor = robot.motorOf(joint.cause.place.index); with.contains(motor))
          take(rated(joint.cause, with.at(motor), without.at(motor), before_.at(motor)), single);
        joint.strength *= spacing;
      }
      for (Tried& all : everywhere) {
        take(rated(withStrength(robot, all.cause, all.strength), summed(with), summed(without), whole_),
             shared);
        all.strength *= spacing;
      }
    }
  }

  Squares squaresWith(const Explanation& causes) const {
    const Groups& groups = replayer_.groups();
    const Residuals residuals = replayer_.residuals(causes);
    Squares squares;
    for (const Cell& cell : groups.cells()) {
      if (!isPosition(groups, cell)) continue;
      const Trial& trial = groups.trials()[cell.trial];
      const int motor = replayer_.mechanism().motorOf(trial.signals[cell.signal].joint);
      squares[motor][trial.recording] += squaresOf(residualsOf(cell, residuals));
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
      if (loss > clearShare) rated.worse.emplace_back(loss, recording);
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
      if (Rated rated = scan.best(*effect); rated.gain > clearShare) ratings.push_back(std::move(rated));
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
