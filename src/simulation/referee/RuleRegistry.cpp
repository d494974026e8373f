#include "simulation/referee/RuleRegistry.h"

#include <tuple>

#include "framework/SelfRegistration.h"

namespace plumbline::simulation {

namespace {

std::vector<RuleEntry>& registered() {
  static std::vector<RuleEntry> rules;
  return rules;
}

}  // namespace

RuleLoader::RuleLoader(RuleEntry entry) {
  registerInOrder(registered(), std::move(entry), "rules",
                  [](const RuleEntry& rule) { return std::tuple(rule.order, std::string_view(rule.name)); });
}

const std::vector<RuleEntry>& registeredRules() { return registered(); }

}  // namespace plumbline::simulation
