#pragma once
#include <string>
#include <vector>

#include "framework/CommandLine.h"
#include "gap/run/RunChanges.h"

namespace plumbline::gap {

/// The options --map and --hold of commands that read runs.
struct ChangesOption {
  std::vector<std::string> map;
  std::string hold;

  void addTo(CommandLine& command) {
    command.option("--map", map,
                   "RECORDING=ROBOT: a joint's name in the runs and its name in the robot's file");
    command
        .option("--hold", hold,
                "Commands between two cycles: zero, each is held until the next; linear, they move "
                "linearly to the next [as the runs say, else zero]")
        .oneOf({"zero", "linear"});
  }
  /// Throws ConfigurationError.
  RunChanges changes() const {
    RunChanges changes{jointNames(map), {}};
    if (!hold.empty()) changes.linearCommands = hold == "linear";
    return changes;
  }
};

}  // namespace plumbline::gap
