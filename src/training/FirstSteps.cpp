#include "training/FirstSteps.h"

#include <algorithm>

#include "framework/ConfigFile.h"
#include "framework/ConfigFolder.h"
#include "framework/ConfigNode.h"
#include "framework/ConfigurationError.h"
#include "framework/NearestName.h"

namespace plumbline::training {
namespace {

constexpr Range sizes{1e-6, 1e6};

void collect(const ConfigSection& section, const std::string& prefix, std::vector<FirstStep>& steps) {
  for (const std::string& key : section.keys()) {
    const ConfigNode& node = *section.node(key);
    if (node.kind == ConfigNode::Kind::map)
      collect(section.section(key), prefix + key + ".", steps);
    else
      steps.push_back({prefix + key, section.get<double>(key, sizes), node.place() + ": " + node.key});
  }
}

}  // namespace

std::vector<FirstStep> firstStepsIn(const ConfigSection& section) {
  std::vector<FirstStep> steps;
  collect(section, "", steps);
  return steps;
}

std::vector<FirstStep> firstSteps(const std::string& search) {
  return firstStepsIn(ConfigFile("search_steps", {configFolder()}).root().section(search));
}

void checkPaths(const std::vector<FirstStep>& steps, const std::vector<std::string>& known) {
  for (const FirstStep& step : steps)
    if (std::ranges::find(known, step.path) == known.end())
      throw ConfigurationError(step.place + ": no parameter \"" + step.path + "\"" +
                               suggestion(step.path, known));
}

}  // namespace plumbline::training
