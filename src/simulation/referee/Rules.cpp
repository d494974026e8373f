#include "simulation/referee/Rules.h"

#include <stdexcept>

namespace plumbline::simulation {

Rules::Rules() {
  for (const RuleEntry& rule : registeredRules()) ofRules.push_back(rule.parameters);
}

RuleParameters& Rules::find(const ParameterList& list) {
  for (RuleParameters& parameters : ofRules)
    if (&parameters.list() == &list) return parameters;
  throw std::logic_error("a rule without MAKE_RULE has no parameters in Rules");
}

}  // namespace plumbline::simulation
