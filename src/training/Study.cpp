#include "training/Study.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "framework/CommandLine.h"
#include "framework/ConfigFile.h"
#include "framework/ConfigurationError.h"
#include "framework/NearestName.h"

namespace plumbline::training {
namespace {

constexpr double most = 1e9;

void readParameters(const ConfigSection& section, std::vector<TaskParameter>& parameters) {
  std::vector<std::string> names;
  for (const TaskParameter& one : parameters) names.push_back(one.name);
  for (const std::string& name : section.keys()) {
    const auto found = std::ranges::find(parameters, name, &TaskParameter::name);
    if (found == parameters.end())
      section.fail(name, "is no parameter of the task" + suggestion(name, names));
    const ConfigSection one = section.section(name);
    const Range any{-most, most};
    found->lower = one.find<double>("min", any).value_or(found->lower);
    found->upper = one.find<double>("max", any).value_or(found->upper);
    if (!(found->lower < found->upper)) one.fail("min", "is not below max");
    found->start =
        std::clamp(one.find<double>("start", any).value_or(found->start), found->lower, found->upper);
    found->sigma = one.find<double>("sigma", Range{1e-9, most}).value_or(found->sigma);
  }
}

}  // namespace

Study readStudy(const std::string& path, const StudyChanges& changes) {
  const ConfigFile file(path);
  const ConfigSection& root = file.root();
  Study study;
  study.task = root.get<std::string>("task");
  std::map<std::string, std::string> values = changes.options;
  if (root.has("options")) {
    const ConfigSection options = root.section("options");
    for (const std::string& key : options.keys()) values.emplace(key, options.get<std::string>(key));
  }
  study.options = TaskOptions(values);
  study.optimizer = optimizerNames()[root.has("optimizer") ? root.choice("optimizer", optimizerNames()) : 0];
  const auto count = [&](const char* key, double lowest, double highest, double fallback) {
    return root.find<double>(key, Range{lowest, highest}).value_or(fallback);
  };
  const auto seed = static_cast<std::uint64_t>(count("seed", 0, most, 1));
  study.search.seed = changes.seed.value_or(seed);
  study.search.population = static_cast<int>(count("population", 4, 100000, 0));
  study.search.ahead = static_cast<int>(count("ahead", 1, 16, 1));
  study.averaging.first = static_cast<int>(count("runs", 1, Search::mostRuns, 1));
  study.averaging.best =
      static_cast<int>(count("runsOfBest", study.averaging.first, Search::mostRuns, study.averaging.first));
  study.averaging.sameSeeds = root.find<bool>("sameSeeds").value_or(true);
  StopCriteria& stop = study.search.stop;
  stop.targetCost = root.find<double>("target").value_or(stop.targetCost);
  if (const auto limit = root.find<double>("generations", Range{1, most}))
    stop.maxGenerations = static_cast<std::int64_t>(*limit);
  if (const auto limit = root.find<double>("evaluations", Range{1, 1e12}))
    stop.maxEvaluations = static_cast<std::int64_t>(*limit);
  try {
    study.parameters = makeTask(study.task, study.options)->parameters();
  } catch (const ConfigurationError& error) {
    throw ConfigurationError(path + ": " + error.what());
  }
  const double sigma = count("sigma", 1e-6, 1e6, 1);
  for (TaskParameter& one : study.parameters) one.sigma *= sigma;
  if (root.has("parameters")) readParameters(root.section("parameters"), study.parameters);
  file.checkUnknown();
  return study;
}

std::string Study::mark() const {
  std::string text = fmt::format("{}; task {}", versionText(), task);
  for (const auto& [key, value] : options.values()) text += fmt::format(" {}={}", key, value);
  text += fmt::format("; {} seed {} population {} ahead {} runs {} of best {} same seeds {}; parameters",
                      optimizer, search.seed, search.population, search.ahead, averaging.first,
                      averaging.best, averaging.sameSeeds);
  for (const TaskParameter& one : parameters)
    text += fmt::format(" {}:{}:{}:{}:{}", one.name, one.start, one.lower, one.upper, one.sigma);
  return text;
}

SearchSpace Study::space() const { return SearchSpace::of(parameters); }

Search Study::makeSearch() const {
  return {makeOptimizer(optimizer, space(), search), averaging, search.seed};
}

}  // namespace plumbline::training
