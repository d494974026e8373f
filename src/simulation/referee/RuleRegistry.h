#pragma once
#include <memory>
#include <string>
#include <vector>

#include "simulation/referee/RuleParameters.h"

namespace plumbline::simulation {

class Rule;

/// A rule that is linked into the program.
struct RuleEntry {
  std::string name;  ///< also its section in a file of rules
  int order = 0;
  std::unique_ptr<Rule> (*make)() = nullptr;
  RuleParameters parameters;  ///< with their defaults
};

/// Takes a rule in before main. A second one of the same name ends the program start: that is a mistake of
/// the build.
class RuleLoader {
public:
  explicit RuleLoader(RuleEntry entry);
};

/// All rules in the order in which they are applied.
const std::vector<RuleEntry>& registeredRules();

}  // namespace plumbline::simulation
