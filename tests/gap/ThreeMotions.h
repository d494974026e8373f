#pragma once
#include <stdexcept>

#include "TwoJointArm.h"

namespace plumbline::gap {

inline constexpr double readingNoise = 5e-4;  // [rad]

/// The cause of an effect at a place. Throws std::out_of_range where there is none.
inline const Cause& causeIn(const Explanation& causes, const char* id, const char* at) {
  for (const Cause& cause : causes)
    if (cause.effect->id == id && cause.place.at == at) return cause;
  throw std::out_of_range(id);
}

/// Three recordings of different motions of the two-joint arm with the causes in.
inline std::vector<Trial> threeMotions(const Explanation& causes) {
  const Mechanism arm = twoJointArm();
  std::vector<Trial> trials;
  for (const double size : {0.5, 0.35, 0.2}) {
    Trial trial = armTrial(arm, 4, size);
    trial.recording = trial.name = "run" + std::to_string(trials.size());
    trials.push_back(recorded(plantOf(arm, causes), trial, readingNoise, 3 + trials.size()));
  }
  return trials;
}

}  // namespace plumbline::gap
