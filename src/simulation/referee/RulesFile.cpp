#include "simulation/referee/RulesFile.h"

#include "framework/ConfigFile.h"
#include "framework/ModuleParameters.h"

namespace plumbline::simulation {

namespace {

constexpr const char* head =
    "# The referee's rules: bin/simulator --rules FILE. A file need name only what it changes.\n"
    "# This one has all rules with their defaults, as the list from which to copy; a test compares it with "
    "the\n"
    "# code. doc/reference/rules.md explains the rules. Written by bin/simulator --print-rules.\n";

void appendLine(std::string& text, const Parameter& parameter, const ParameterPointer& value) {
  text += "  " + parameter.name + ": " + parameterText(value) + "  # ";
  if (!parameter.unit.empty()) text += parameter.unit + "; ";
  text += parameter.comment + '\n';
}

void appendSection(std::string& text, const std::string& name, const std::string& comment,
                   const ParameterList& list, void* owner) {
  if (list.empty()) return;
  text += '\n' + name + ":" + (comment.empty() ? "" : "  # " + comment) + '\n';
  list.visit(owner, [&](const std::string&, const Parameter& parameter, const ParameterPointer& value) {
    appendLine(text, parameter, value);
  });
}

}  // namespace

Rules readRules(const std::string& path, const Rules& fallback) {
  const ConfigFile file(path);
  const ConfigSection& root = file.root();
  Rules rules = fallback;
  readParameters(root, Rules::parameterList(), &rules);
  const auto& known = registeredRules();
  for (std::size_t i = 0; i < known.size(); ++i) {
    RuleParameters& parameters = rules.ofRules[i];
    if (!parameters.list().empty() && root.has(known[i].name))
      readParameters(root.section(known[i].name), parameters.list(), parameters.owner());
  }
  file.checkUnknown();
  return rules;
}

std::string rulesText(const Rules& given) {
  Rules rules = given;
  std::string text = head;
  for (const ParameterList::Entry& group : Rules::parameterList().entries())
    appendSection(text, group.parameter.name, group.parameter.comment, *group.group, group.groupOf(&rules));
  const auto& known = registeredRules();
  for (std::size_t i = 0; i < known.size(); ++i)
    appendSection(text, known[i].name, "", rules.ofRules[i].list(), rules.ofRules[i].owner());
  return text;
}

}  // namespace plumbline::simulation
