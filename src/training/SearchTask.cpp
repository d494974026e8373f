#include "training/SearchTask.h"

#include <fmt/format.h>

#include <algorithm>

#include "framework/ConfigurationError.h"
#include "framework/LinkedTwice.h"
#include "framework/NearestName.h"

namespace plumbline::training {
namespace {

std::vector<TaskKind>& registered() {
  static std::vector<TaskKind> kinds;
  return kinds;
}

}  // namespace

std::string SearchTask::file(const Eigen::VectorXd&, const std::string&,
                             const std::map<std::string, double>&) const {
  return {};
}

TaskLoader::TaskLoader(const TaskKind& kind) {
  std::vector<TaskKind>& kinds = registered();
  if (std::ranges::count(kinds, std::string_view(kind.name), &TaskKind::name) > 0)
    endLinkedTwice("tasks", kind.name);
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
