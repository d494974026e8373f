#include "training/SearchTask.h"

#include <fmt/format.h>

#include "framework/ConfigurationError.h"
#include "framework/NearestName.h"
#include "framework/SelfRegistration.h"

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
  registerInOrder(registered(), kind, "tasks",
                  [](const TaskKind& k) { return std::tuple(0, std::string_view(k.name)); });
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
