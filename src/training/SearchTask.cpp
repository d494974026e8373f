#include "training/SearchTask.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstdio>
#include <cstdlib>

#include "framework/ConfigurationError.h"
#include "framework/NearestName.h"

namespace plumbline::training {
namespace {

std::vector<TaskKind>& registered() {
  static std::vector<TaskKind> kinds;
  return kinds;
}

}  // namespace

double TaskOptions::number(const std::string& key, double fallback, double lowest, double highest) const {
  const auto found = values_.find(key);
  if (found == values_.end()) return fallback;
  const std::string& text = found->second;
  double value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc() || end != text.data() + text.size() || !(value >= lowest && value <= highest))
    throw ConfigurationError(
        fmt::format("option {}: \"{}\" is no number from {:g} to {:g}", key, text, lowest, highest));
  return value;
}

std::string TaskOptions::word(const std::string& key, const std::string& fallback,
                              const std::vector<std::string>& words) const {
  const auto found = values_.find(key);
  const std::string& text = found == values_.end() ? fallback : found->second;
  if (!words.empty() && std::ranges::count(words, text) == 0)
    throw ConfigurationError(
        fmt::format("option {}: \"{}\" is not one of {}", key, text, fmt::join(words, ", ")));
  return text;
}

void TaskOptions::check(const std::vector<std::string>& known) const {
  for (const auto& [key, value] : values_)
    if (std::ranges::count(known, key) == 0)
      throw ConfigurationError("unknown option \"" + key + '"' + suggestion(key, known));
}

std::string SearchTask::file(const Eigen::VectorXd&, const std::string&,
                             const std::map<std::string, double>&) const {
  return {};
}

TaskLoader::TaskLoader(const TaskKind& kind) {
  std::vector<TaskKind>& kinds = registered();
  if (std::ranges::count(kinds, std::string_view(kind.name), &TaskKind::name) > 0) {
    std::fprintf(stderr, "two tasks with the name %s are linked into this program\n", kind.name);
    std::exit(2);
  }
  kinds.insert(std::ranges::upper_bound(kinds, std::string_view(kind.name), {}, &TaskKind::name), kind);
}

const std::vector<TaskKind>& searchTasks() { return registered(); }

std::unique_ptr<SearchTask> makeTask(std::string_view name, const TaskOptions& options) {
  std::vector<std::string> names;
  for (const TaskKind& kind : registered()) {
    if (kind.name == name) return kind.make(options);
    names.emplace_back(kind.name);
  }
  const std::string near = suggestion(name, names);
  throw ConfigurationError(
      fmt::format("there is no task \"{}\"{}", name,
                  near.empty() ? fmt::format("; there are: {}", fmt::join(names, ", ")) : near));
}

}  // namespace plumbline::training
