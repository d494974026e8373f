#include "simulation/referee/RuleRegistry.h"

#include <algorithm>
#include <tuple>

#include "framework/LinkedTwice.h"

namespace plumbline::simulation {

namespace {

std::vector<RuleEntry>& registered() {
  static std::vector<RuleEntry> rules;
  return rules;
}

}  // namespace

RuleLoader::RuleLoader(RuleEntry entry) {
  std::vector<RuleEntry>& rules = registered();
  if (std::ranges::count(rules, entry.name, &RuleEntry::name) > 0) endLinkedTwice("rules", entry.name);
  const auto place = [](const RuleEntry& rule) { return std::tie(rule.order, rule.name); };
  rules.insert(std::ranges::upper_bound(rules, place(entry), {}, place), std::move(entry));
}

const std::vector<RuleEntry>& registeredRules() { return registered(); }

}  // namespace plumbline::simulation
