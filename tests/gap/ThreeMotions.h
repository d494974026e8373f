#pragma once
#include "TwoJointArm.h"

namespace plumbline::gap {

/// Three recordings of different motions of the two-joint arm with the causes in; the readings' noise is 0.5
/// mrad.
inline std::vector<Trial> threeMotions(const Explanation& causes) {
  const Mechanism arm = twoJointArm();
  std::vector<Trial> trials;
  for (const double size : {0.5, 0.35, 0.2}) {
    Trial trial = armTrial(arm, 4, size);
    trial.recording = trial.name = "run" + std::to_string(trials.size());
    trials.push_back(recorded(plantOf(arm, causes), trial, 5e-4, 3 + trials.size()));
  }
  return trials;
}

}  // namespace plumbline::gap
