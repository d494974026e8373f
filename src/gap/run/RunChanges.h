#pragma once
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "gap/run/Run.h"

namespace plumbline::gap {

/// Changes to a run when it is read.
struct RunChanges {
  std::map<std::string, std::string> joints;  ///< from the recording's name of a joint to the robot's
  std::optional<bool> linearCommands;         ///< Run::linearCommands
};

/// Joints from words like `l_knee=LKneePitch`: the recording's name, then the robot's. Throws
/// ConfigurationError for a word of another form, and for a name that occurs twice.
std::map<std::string, std::string> jointNames(const std::vector<std::string>& words);

/// Applies the changes to a run: its channels, servos and timing. Throws RunError if a joint of the run
/// already has the new name.
void apply(const RunChanges& changes, Run& run);

}  // namespace plumbline::gap
