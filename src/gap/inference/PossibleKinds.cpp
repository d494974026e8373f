#include "gap/inference/PossibleKinds.h"

#include <algorithm>

namespace plumbline::gap {

namespace {

bool measured(const Groups& groups, SignalKind a, SignalKind b) {
  return std::ranges::any_of(groups.cells(), [&](const Cell& cell) {
    const SignalKind kind = groups.trials()[cell.trial].signals[cell.signal].kind;
    return kind == a || kind == b;
  });
}

/// Whether recordings of this sort can show an effect at that place at all.
bool canShow(const Groups& groups, const Mechanism& robot, const Effect& effect, const Place& place) {
  const bool free = std::ranges::any_of(groups.trials(), [](const Trial& trial) { return trial.freeBase; });
  switch (place.site) {
    case Site::imu:
      return measured(groups, SignalKind::gyro, SignalKind::accelerometer);
    case Site::foot:
      return measured(groups, SignalKind::force, SignalKind::force);
    case Site::ground:
      return free;
    case Site::link:
      return free || !robot.chain(place.index).empty();
    default:
      break;
  }
  return !effect.canBeAt || effect.canBeAt(robot, place);
}

}  // namespace

std::vector<Cause> possibleKinds(const Groups& groups, const Mechanism& robot) {
  std::vector<Cause> kinds;
  for (const Effect* effect : effects())
    for (const Place& place : placesOf(*effect, robot)) {
      if (effect->decoded || !canShow(groups, robot, *effect, place)) continue;
      for (int variant = 0; variant < effect->numVariants(); ++variant)
        kinds.push_back({effect, place, 0, variant});
    }
  return kinds;
}

}  // namespace plumbline::gap
