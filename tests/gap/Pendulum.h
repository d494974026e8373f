#pragma once
#include "TwoJointArm.h"
#include "robot/MechanismFile.h"

namespace plumbline::gap {

/// A weak servo that swings half a kilogram at 0.1 m (config/robots/xl330_pendulum.json): a lost command
/// shows late, and all effects move one joint.
inline Mechanism pendulum() { return findMechanism("xl330_pendulum"); }

inline Cause causeOfPendulum(const char* id, const char* place, double value) {
  const Effect* effect = findEffect(id);
  return {effect, findPlace(*effect, pendulum(), place, ""), value, 0};
}

/// 12 s of its motion, recorded twice, each time with another such share of the commands lost.
inline std::vector<Trial> pendulumRecordedTwice(const Plant& plant, double lostShare) {
  std::vector<Trial> trials;
  for (const std::uint64_t seed : {11, 12}) {
    Trial trial = armTrial(pendulum(), 12, 0.9);
    Random random(seed);
    std::vector<std::uint8_t> lost(trial.cycles(), 0);
    for (auto& cycle : lost) cycle = random.uniform() < lostShare;
    ReplayOptions options;
    options.lostCycles = &lost;
    trials.push_back(recorded(plant, std::move(trial), 5e-4, seed, options));
  }
  return trials;
}

}  // namespace plumbline::gap
