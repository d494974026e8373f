#pragma once
#include "TwoJointArm.h"
#include "robot/MechanismFile.h"

namespace plumbline::gap {

/// A weak servo that swings half a kilogram at 0.1 m (config/robots/xl330_pendulum.json): a lost command
/// shows late, and all effects move one joint.
inline Mechanism pendulum() { return findMechanism("xl330_pendulum"); }

inline Cause causeOfPendulum(const char* id, const char* place, double value) {
  return causeOf(pendulum(), id, place, value);
}

/// 12 s of its motion, recorded twice, each time with another such share of the commands lost.
inline std::vector<Trial> pendulumRecordedTwice(const Plant& plant, double lostShare) {
  return recordedTwice(plant, 5e-4, lostShare, armTrial(pendulum(), 12, 0.9));
}

}  // namespace plumbline::gap
