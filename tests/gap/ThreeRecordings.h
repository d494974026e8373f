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

/// A motion of the arm with the causes in, recorded twice, and a smaller one; a tenth of the commands is
/// lost.
inline std::vector<Trial> recordingsWithLosses(const Explanation& causes, double seconds) {
  const Mechanism arm = twoJointArm();
  const Plant plant = plantOf(arm, causes);
  std::vector<Trial> trials = recordedTwice(plant, 5e-4, 0.1, armTrial(arm, seconds));
  trials.push_back(recordedTwice(plant, 5e-4, 0.1, armTrial(arm, seconds, 0.3))[1]);
  trials.back().recording = "smaller";
  return trials;
}

}  // namespace plumbline::gap
