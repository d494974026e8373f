#include "simulation/referee/RuleParameters.h"

#include <vector>

namespace plumbline::simulation {

bool RuleParameters::operator==(const RuleParameters& other) const {
  if (list_ != other.list_) return false;
  std::vector<ParameterValue> ours, theirs;
  const auto collectInto = [](std::vector<ParameterValue>& all) {
    return [&all](const std::string&, const Parameter&, const ParameterPointer& pointer) {
      all.push_back(parameterValue(pointer));
    };
  };
  list_->visit(values_->owner(), collectInto(ours));
  list_->visit(other.values_->owner(), collectInto(theirs));
  return ours == theirs;
}

}  // namespace plumbline::simulation
