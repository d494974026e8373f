#include "gap/diagnosis/PossibleCauses.h"

#include <algorithm>

#include "gap/diagnosis/DeviatingJoints.h"
#include "gap/diagnosis/UnderLoad.h"
#include "gap/replay/Ensemble.h"

namespace plumbline::gap {

namespace {

bool measured(const Evidence& data, SignalKind a, SignalKind b) {
  return std::ranges::any_of(data.trials(), [&](const Trial& trial) {
    return std::ranges::any_of(trial.signals, [&](const Signal& s) { return s.kind == a || s.kind == b; });
  });
}

/// Whether a cause would bring a limit cycle to a joint at which the base has a cause already: the
/// uncertainty of the limit cycle would excuse whatever that cause does not explain.
bool wouldExcuse(const Cause& cause, const Evaluator& evaluator) {
  const auto there = [&](const Cause& other) { return other.place == cause.place; };
  if (cause.place.site != Site::joint || std::ranges::none_of(evaluator.base(), there)) return false;
  return hasLimitCycle(
      plantOf(evaluator.mechanism(), {cause}).joints[static_cast<std::size_t>(cause.place.index)]);
}

}  // namespace

std::vector<Cause> possibleCauses(const Evaluator& evaluator) {
  const Mechanism& robot = evaluator.mechanism();
  const DeviatingJoints suspects(evaluator);
  const UnderLoad underLoad(evaluator);
  const bool imu = measured(evaluator.evidence(), SignalKind::gyro, SignalKind::accelerometer);
  const bool forces = measured(evaluator.evidence(), SignalKind::force, SignalKind::force);
  const auto possible = [&](const Effect& effect, const Place& place) {
    const auto index = static_cast<std::size_t>(place.index);
    switch (place.site) {
      case Site::imu:
        return imu;
      case Site::foot:
        return forces;
      case Site::ground:
        return evaluator.hasFloatingBase();
      case Site::everywhere:
        // A servo's own effect is looked for in all of them where several joints are off.
        if (effect.ofServo) return std::ranges::count(suspects.joint, true) > 1;
        return suspects.any;
      case Site::joint:
        return suspects.joint[index] || (suspects.weak[index] && effect.screening.behindGear) ||
               (suspects.chain[index] && effect.screening.inNeighbours);
      case Site::link: {
        const std::vector<int> chain = robot.chain(place.index);
        if (chain.empty()) return evaluator.hasFloatingBase();
        return static_cast<bool>(suspects.chain[static_cast<std::size_t>(chain.back())]);
      }
    }
    return false;
  };
  std::vector<Cause> causes;
  for (const Effect* effect : effects())
    for (const Place& place : placesOf(*effect, robot)) {
      const auto there = [&](const Cause& cause) { return cause.effect == effect && cause.place == place; };
      if (effect->decoded || (effect->canBeAt && !effect->canBeAt(robot, place)) ||
          (!possible(*effect, place) && !underLoad.shows(*effect, place)) ||
          std::ranges::any_of(evaluator.base(), there))
        continue;
      const double scale = effect->scaleAt(robot, place);
      for (int variant = 0; variant < effect->numVariants(); ++variant)
        for (const double start : effect->starts) {
          const Cause cause{effect, place, start * scale, variant};
          if (!wouldExcuse(cause, evaluator)) causes.push_back(cause);
        }
    }
  return causes;
}

std::vector<std::vector<Cause>> byKind(const Mechanism& mechanism, const std::vector<Cause>& starts) {
  std::vector<std::vector<Cause>> kinds;
  for (const Cause& start : starts) {
    if (anyLimitCycle(plantOf(mechanism, {start}))) continue;
    const auto same = std::ranges::find_if(kinds, [&](const std::vector<Cause>& kind) {
      return kind.front().sameKind(start) && kind.front().variant == start.variant;
    });
    if (same == kinds.end())
      kinds.push_back({start});
    else
      same->push_back(start);
  }
  return kinds;
}

}  // namespace plumbline::gap
