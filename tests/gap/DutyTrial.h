#pragma once
#include "TwoJointArm.h"
#include "robot/MechanismFile.h"

namespace plumbline::gap {

/// A pendulum on a DC motor that reports position and duty, both as this reality shows them: 100 Hz, sums of
/// sines and slow reversals.
inline Trial dutyTrial(const Explanation& reality, double seconds, double noise, std::uint64_t seed = 3,
                       double size = 0.5) {
  const Mechanism pendulum = findMechanism("xl330_pendulum");
  Trial trial = armTrial(pendulum, seconds, size);
  trial.recording = trial.name = "pendulum" + std::to_string(seed);
  trial.motion += " " + std::to_string(size);
  const Plant plant = plantOf(trial, reality);
  trial = recorded(plant, trial, noise, seed);
  Signal duty;
  duty.name = "duty.pendulum";
  duty.kind = SignalKind::duty;
  duty.joint = 0;
  duty.values.assign(trial.cycles(), 0);
  trial.signals.push_back(duty);
  // The servo sees the angle that was measured, rounding and all.
  const Prediction shown = replay(plant, trial);
  trial.signals.back().values = shown.values.back();
  return trial;
}

}  // namespace plumbline::gap
