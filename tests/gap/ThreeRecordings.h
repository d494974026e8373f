#pragma once
#include "TwoJointArm.h"

namespace plumbline::gap {

/// Three recordings of different motions of the two-joint arm with the causes in.
inline std::vector<Trial> recordings(const Explanation& causes, double seconds = 4) {
  constexpr double noise = 5e-4;
  const Mechanism arm = twoJointArm();
  std::vector<Trial> trials;
  for (const double size : {0.5, 0.35, 0.2}) {
    Trial trial = armTrial(arm, seconds, size);
    trial.recording = trial.name = "run" + std::to_string(trials.size());
    trials.push_back(recorded(plantOf(arm, causes), trial, noise, 3 + trials.size()));
  }
  return trials;
}

}  // namespace plumbline::gap
