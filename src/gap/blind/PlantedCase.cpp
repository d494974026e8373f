#include "gap/blind/PlantedCase.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "framework/StopSignal.h"
#include "gap/blind/PlantedSet.h"
#include "gap/diagnosis/Noise.h"
#include "gap/effects/Effects.h"

namespace plumbline::gap {

namespace {

// Rules of the planted benchmark; doc/reference/gap-blind.md says why.
constexpr double mostLeft = 0.05;            ///< of the change by the planted cause
constexpr double leastCosineWithGap = -0.5;  ///< of the change with the own gap, else the model comes nearer
constexpr double mostLeftByAlike = 0.1;      ///< of the change by a cause in another name
constexpr double leastCosineOfAlike = 0.9;   ///< of a small cause with the change, to be tried for that
constexpr double leastNoise = 2e-4;          ///< [rad]
constexpr int tries = 60, triesOfKind = 4;

/// The joint that moves what a cause is at; -1: all of them.
int jointOf(const Mechanism& robot, const Place& place) {
  if (place.site == Site::joint) return robot.motorOf(place.index);
  if (place.site != Site::link) return robot.onlyMotor();
  const std::vector<int> chain = robot.chain(place.index);
  return chain.empty() ? -1 : robot.motorOf(chain.back());
}

/// Causes of the library at the same joint that look the same in these recordings.
std::vector<NamedPlace> alikeTo(const PlantingBase& base, const RealRecordings& with, const Cause& plant) {
  std::vector<NamedPlace> names;
  const std::vector<double> planted = residualsOf(with, {}), wanted = minus(base.nominal, planted);
  const Mechanism& robot = with.robot;
  for (const Effect* effect : effects()) {
    if (effect->decoded) continue;
    for (const Place& place : placesOf(*effect, robot)) {
      const bool joints = place.site == Site::joint || place.site == Site::link ||
                          (place.site == Site::everywhere && place.index < 0);
      if (!joints || (effect == plant.effect && place == plant.place)) continue;
      if (jointOf(robot, place) != jointOf(robot, plant.place)) continue;
      if (effect->canBeAt && !effect->canBeAt(robot, place)) continue;
      for (const double start : effect->starts) {
        StopSignal::throwIfCaught();
        const Cause cause{effect, place, start * effect->scaleAt(robot, place)};
        if (cosine(minus(residualsOf(with, {cause}), planted), wanted) < leastCosineOfAlike) continue;
        if (leftOfPlant(base.recordings, with, cause) > mostLeftByAlike) continue;
        names.push_back({std::string(effect->id), place.at, place.axis ? std::string(1, place.axis) : ""});
        break;
      }
    }
  }
  return names;
}

/// Largest change of a position over its noise, as a root mean square.
void setSeverity(const PlantingBase& base, const RealRecordings& with, BlindCase& c) {
  std::size_t from = 0;
  const std::vector<double> planted = residualsOf(with, {});
  c.ratio = 0;
  for (std::size_t t = 0; t < base.recordings.trials.size(); ++t) {
    const Trial& trial = base.recordings.trials[t];
    for (std::size_t s = 0; s < trial.signals.size(); ++s) {
      if (trial.signals[s].kind != SignalKind::position) continue;
      const std::size_t cycles = residualCycles(trial);
      const auto part = [&](const std::vector<double>& all) {
        return std::vector<double>(all.begin() + static_cast<std::ptrdiff_t>(from),
                                   all.begin() + static_cast<std::ptrdiff_t>(from + cycles));
      };
      const double ratio =
          differenceOf(part(planted), part(base.nominal)) / std::max(leastNoise, base.noise[t][s]);
      if (ratio > c.ratio) {
        c.ratio = ratio;
        c.ratioChannel = "run" + std::to_string(t + 1) + "/" + trial.signals[s].name;
      }
      from += cycles;
    }
  }
}

bool atSamePlace(const Explanation& causes, const Cause& cause) {
  return std::ranges::any_of(causes, [&](const Cause& c) {
    return c.effect == cause.effect || (c.place.site == cause.place.site && c.place.at == cause.place.at);
  });
}

/// A cause of a kind with a drawn size; nothing where it does not fit.
bool drawCause(const PlantingBase& base, const std::vector<Cause>& kind, Random& random, Cause& cause) {
  cause = kind[static_cast<std::size_t>(random.uniform() * static_cast<double>(kind.size()))];
  const double share = std::exp(random.uniform(std::log(leastPlant), std::log(mostPlant)));
  cause = sized(base.recordings, cause, share * base.gap);
  if (cause.value == cause.effect->nominal) return false;
  const RealRecordings with = planted(base.recordings, cause);
  const std::vector<double> changed = residualsOf(with, {});
  const double change = differenceOf(changed, base.nominal);
  return change > 0 && cosine(minus(changed, base.nominal), base.nominal) > leastCosineWithGap &&
         differenceOf(residualsOf(with, {cause}), base.nominal) <= mostLeft * change;
}

}  // namespace

PlantingBase::PlantingBase(RealRecordings from) : recordings(std::move(from)) {
  nominal = residualsOf(recordings, {});
  gap = differenceOf(nominal, std::vector<double>(nominal.size(), 0));
  if (!(gap > 0)) throw std::runtime_error("no position can be compared with the replay");
  for (const auto& trial : estimateNoise(recordings.trials)) {
    noise.emplace_back();
    for (const SignalNoise& signal : trial) noise.back().push_back(signal.sigma);
  }
  for (const Effect* effect : plantable()) {
    std::vector<Cause> plants = plantsFor(recordings, *effect);
    if (!plants.empty()) possible.push_back(std::move(plants));
  }
  if (possible.empty()) throw std::runtime_error("no joint has both commands and positions");
}

RealRecordings plantCase(const PlantingBase& base, std::size_t turn, Random& random, BlindCase& c) {
  const std::size_t wanted = c.kind == BlindKind::none ? 0 : c.kind == BlindKind::mixture ? 2 : 1;
  Explanation causes;
  RealRecordings with = base.recordings;
  for (int tried = 0, triedOfKind = 0; causes.size() < wanted; ++tried) {
    StopSignal::throwIfCaught();
    if (tried == tries)
      throw std::runtime_error(
          "no cause moves these recordings as much as their own gap and is exact; "
          "recordings with more motion may help");
    // The kinds in turn; a kind that does not fit in a few tries gives way to any other.
    const std::size_t kinds = base.possible.size(),
                      chance = static_cast<std::size_t>(random.uniform() * static_cast<double>(kinds));
    const std::vector<Cause>& kind =
        base.possible[triedOfKind++ < triesOfKind ? (turn + causes.size()) % kinds : chance];
    Cause cause;
    try {
      if (!drawCause(base, kind, random, cause) || atSamePlace(causes, cause)) continue;
      RealRecordings both = planted(with, cause);
      Explanation all = causes;
      all.push_back(cause);
      const double change = differenceOf(residualsOf(both, {}), base.nominal);
      if (differenceOf(residualsOf(both, all), base.nominal) > mostLeft * change) continue;
      with = std::move(both);
      causes = std::move(all);
      triedOfKind = 0;
    } catch (const std::runtime_error&) {
      continue;  // nothing would be left of a mass, say
    }
  }
  for (const Cause& cause : causes) {
    BlindEffect effect{std::string(cause.effect->id),
                       cause.place.at,
                       cause.place.axis ? std::string(1, cause.place.axis) : "",
                       cause.value,
                       {},
                       {}};
    effect.alike = alikeTo(base, planted(base.recordings, cause), cause);
    c.effects.push_back(std::move(effect));
  }
  if (!causes.empty()) setSeverity(base, with, c);
  // What changes no answer: the clock begins elsewhere, and the base, which is fixed, is heavier.
  const double later = std::round(1e3 * random.uniform(0, 0.9)) / 1e3, heavier = 1 + random.uniform();
  with.robot.links.front().mass *= heavier;
  for (Run& run : with.runs)
    for (double& t : run.t) t += later;
  return with;
}

}  // namespace plumbline::gap
