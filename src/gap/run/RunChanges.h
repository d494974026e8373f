#pragma once
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "gap/run/Run.h"

namespace plumbline::gap {

/// What is to be read otherwise than a run says it.
struct RunChanges {
  std::map<std::string, std::string> joints;  ///< the robot's name of a joint, by the recording's
  std::optional<bool> linearCommands;         ///< Run::linearCommands
};

/// Joints from words like `l_knee=LKneePitch`: the recording's name, then the robot's. Throws
/// ConfigurationError for a word of another form, and for a name that is there twice.
std::map<std::string, std::string> jointNames(const std::vector<std::string>& words);

/// Puts the changes into a run: its channels, servos and timing. Throws RunError where a joint of the run has
/// the new name already.
void apply(const RunChanges& changes, Run& run);

}  // namespace plumbline::gap
