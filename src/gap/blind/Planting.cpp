#include "gap/blind/Planting.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <stdexcept>

#include "gap/effects/Effects.h"
#include "gap/inference/Groups.h"
#include "gap/inference/Strengths.h"
#include "gap/replay/Replay.h"
#include "gap/replay/TrialOf.h"

namespace plumbline::gap {

namespace {

/// Whether the joint was sent commands and its position read, in a run at least.
bool wasRecorded(const RealRecordings& base, int joint) {
  const std::string& name = base.robot.joints[static_cast<std::size_t>(joint)].name;
  for (const Run& run : base.runs)
    if (run.find(ChannelKind::command, name) && run.find(ChannelKind::position, name)) return true;
  return false;
}

double along(const std::vector<double>& a, const std::vector<double>& b) {
  double sum = 0;
  for (std::size_t k = 0; k < a.size(); ++k)
    if (std::isfinite(a[k] * b[k])) sum += a[k] * b[k];
  return sum;
}

bool canBePlanted(const RealRecordings& base, const Effect& effect, const Place& place) {
  const Mechanism& robot = base.robot;
  if (effect.canBeAt && !effect.canBeAt(robot, place)) return false;
  if (place.site == Site::everywhere) return effect.planting.ofAll && place.index < 0;
  if (place.site == Site::link) {
    const std::vector<int> chain = robot.chain(place.index);
    if (chain.empty() || !wasRecorded(base, chain.back())) return false;
  } else if (!wasRecorded(base, place.index) ||
             robot.joints[static_cast<std::size_t>(place.index)].driver >= 0) {
    return false;
  }
  return !effect.planting.possible || effect.planting.possible(robot, place);
}

}  // namespace

RealRecordings::RealRecordings(Mechanism model, std::vector<Run> recordings)
    : robot(std::move(model)), runs(std::move(recordings)) {
  for (const Run& run : runs) trials.push_back(trialOf(run, robot));
}

std::vector<const Effect*> plantable() {
  std::vector<const Effect*> list;
  std::ranges::copy_if(effects(), std::back_inserter(list),
                       [](const Effect* effect) { return effect->planting.rank > 0; });
  std::ranges::stable_sort(list, {}, [](const Effect* effect) { return effect->planting.rank; });
  return list;
}

std::vector<Cause> plantsFor(const RealRecordings& base, const Effect& effect) {
  std::vector<Cause> plants;
  for (const Place& place : placesOf(effect, base.robot))
    if (canBePlanted(base, effect, place))
      for (const double start : effect.starts)
        plants.push_back({&effect, place, start * effect.scaleAt(base.robot, place)});
  return plants;
}

std::vector<Cause> plantsFor(const RealRecordings& base) {
  std::vector<Cause> plants;
  for (const Effect* effect : plantable())
    for (Cause& cause : plantsFor(base, *effect)) plants.push_back(std::move(cause));
  return plants;
}

RealRecordings planted(const RealRecordings& base, const Cause& cause) {
  RealRecordings other = base;
  cause.effect->planting.apply({other.robot, other.runs}, cause.place, cause.value);
  return {std::move(other.robot), std::move(other.runs)};
}

std::vector<double> residualsOf(const RealRecordings& base, const Explanation& causes) {
  std::vector<double> residuals;
  for (const Trial& trial : base.trials) {
    const Prediction prediction = replay(plantOf(trial, causes), trial);
    for (std::size_t s = 0; s < trial.signals.size(); ++s) {
      if (trial.signals[s].kind != SignalKind::position || prediction.values[s].empty()) continue;
      for (std::size_t k = firstScored(trial); k < trial.cycles(); ++k)
        residuals.push_back(trial.signals[s].values[k] - prediction.values[s][k]);
    }
  }
  return residuals;
}

std::size_t residualCycles(const Trial& trial) { return trial.cycles() - firstScored(trial); }

std::vector<double> minus(std::vector<double> a, const std::vector<double>& b) {
  for (std::size_t k = 0; k < a.size(); ++k) a[k] -= b[k];
  return a;
}

double cosine(const std::vector<double>& a, const std::vector<double>& b) {
  double aa = 0, bb = 0, ab = 0;
  for (std::size_t k = 0; k < a.size(); ++k) {
    if (!std::isfinite(a[k] * b[k])) continue;
    aa += a[k] * a[k], bb += b[k] * b[k], ab += a[k] * b[k];
  }
  return aa > 0 && bb > 0 ? ab / std::sqrt(aa * bb) : 0;
}

double differenceOf(const std::vector<double>& a, const std::vector<double>& b) {
  double squares = 0, n = 0;
  for (std::size_t k = 0; k < a.size(); ++k)
    if (const double d = a[k] - b[k]; std::isfinite(d)) squares += d * d, ++n;
  return n > 0 ? std::sqrt(squares / n) : 0;
}

Cause sized(const RealRecordings& base, Cause cause, double change) {
  const std::vector<double> before = residualsOf(base, {});
  const double nominal = cause.effect->nominal;
  const Bounds bounds = cause.effect->boundsAt(base.robot, cause.place);
  const double end = cause.value > nominal ? bounds.upper : bounds.lower;
  double low = 0, high = 0.01;
  const auto moves = [&](double share) {
    // Ratios go towards their ends by powers.
    cause.value = nominal == 1 ? std::pow(std::max(end, 0.1), share) : nominal + share * (end - nominal);
    try {
      return differenceOf(residualsOf(planted(base, cause), {}), before);
    } catch (const std::runtime_error&) {
      return std::numeric_limits<double>::infinity();
    }
  };
  while (high < 1 && moves(high) < change) low = high, high *= 2;
  for (int round = 0; round < 7; ++round) {
    const double middle = (low + high) / 2;
    (moves(middle) < change ? low : high) = middle;
  }
  const double moved = moves(low);
  if (low >= 0.95 || !(moved > 0.7 * change && moved < 1.4 * change)) cause.value = nominal;
  return cause;
}

double leftOfPlant(const RealRecordings& base, const RealRecordings& planted, const Cause& cause) {
  const std::vector<double> wanted = residualsOf(base, {}), nominal = residualsOf(planted, {});
  const double whole = differenceOf(wanted, nominal);
  double left = 1, strength = cause.effect->strengthOf(cause.value);
  for (int round = 0; round < 6; ++round) {
    const std::vector<double> here = residualsOf(planted, {withStrength(planted.robot, cause, strength)});
    left = std::min(left, differenceOf(wanted, here) / whole);
    const double step = 0.02 * strength;
    const std::vector<double> slope =
        minus(residualsOf(planted, {withStrength(planted.robot, cause, strength + step)}), here);
    const double square = along(slope, slope);
    if (!(square > 0)) break;
    strength += step * along(minus(wanted, here), slope) / square;
  }
  return left;
}

}  // namespace plumbline::gap
