#pragma once
#include <string>
#include <vector>

#include "ThreeMotions.h"

namespace plumbline::gap {

/// Motions of the two-joint arm in the recordings "monday", "tuesday" and "friday". The first cause was not
/// in force in the recording of the given name.
inline std::vector<Trial> someRecordings(const Explanation& causes, const std::string& withoutFirst) {
  std::vector<Trial> trials;
  const Mechanism arm = twoJointArm();
  for (const char* day : {"monday", "tuesday", "friday"}) {
    Trial trial = armTrial(arm, 3, 0.4 + 0.03 * static_cast<double>(trials.size()));
    trial.recording = trial.motion = day;
    Explanation there = causes;
    if (day == withoutFirst) there.erase(there.begin());
    trials.push_back(recorded(plantOf(arm, there), trial, 5e-4, trials.size() + 1));
  }
  return trials;
}

}  // namespace plumbline::gap
