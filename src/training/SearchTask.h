#pragma once
#include <Eigen/Core>
#include <cstdint>
#include <map>
#include <memory>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "motion/MotionParameters.h"
#include "trials/TaskOptions.h"
#include "trials/TaskOutcome.h"

namespace plumbline::training {

using TaskParameter = motion::SearchedNumber;

/// The name of a figure's spread over many runs is the figure's and this.
constexpr const char* deviationSuffix = ".deviation";

/// Something that a search improves: parameters in, cost of a run out. A run depends only on parameters and
/// seed, not on earlier runs. One thread at a time.
class SearchTask {
public:
  virtual ~SearchTask() = default;
  SearchTask(const SearchTask&) = delete;
  SearchTask& operator=(const SearchTask&) = delete;

  virtual const std::vector<TaskParameter>& parameters() const = 0;
  virtual TaskOutcome run(const Eigen::VectorXd& parameters, std::uint64_t seed) = 0;
  /// The result as a file for the agent, below comment lines of `heading`; empty: there is none. figures:
  /// means of runs of these parameters, where they were measured, and standard deviations of the runs, whose
  /// names end in deviationSuffix. A run with the parameters is a run of the file: what it rounds is rounded
  /// in both.
  virtual std::string file(const Eigen::VectorXd& parameters, const std::string& heading,
                           const std::map<std::string, double>& figures = {}) const;

protected:
  SearchTask() = default;
};

/// A task that can be chosen by name; its own file makes it known by MAKE_TASK.
struct TaskKind {
  const char* name;
  const char* what;                        ///< one line for lists
  const ParameterList* options;            ///< of the struct that the task reads them into
  std::shared_ptr<void> (*makeOptions)();  ///< an owner with the defaults
  std::unique_ptr<SearchTask> (*make)(const TaskOptions& options);
};

/// Takes a task in before main. A second one of the same name ends the program's start.
class TaskLoader {
public:
  explicit TaskLoader(const TaskKind& kind);
};

template <typename Task>
TaskKind taskKind(const char* name, const char* what) {
  using Options = typename Task::Options;
  return {name, what, &Options::parameterList(),
          []() -> std::shared_ptr<void> { return std::make_shared<Options>(); },
          [](const TaskOptions& options) -> std::unique_ptr<SearchTask> {
            return std::make_unique<Task>(options.as<Options>());
          }};
}

/// MAKE_TASK(StandUpTask, "standUp", "standing up from front, back or side"): in the task's .cpp. The class
/// has a type Options with PARAMETERS, and a constructor that takes it.
#define MAKE_TASK(Task, name, what)                            \
  static const ::plumbline::training::TaskLoader Task##Loader( \
      ::plumbline::training::taskKind<Task>(name, what));

/// The tasks linked into the program, by name.
const std::vector<TaskKind>& searchTasks();

/// Throws ConfigurationError naming the nearest task, or what the task makes of its options.
std::unique_ptr<SearchTask> makeTask(std::string_view name, const TaskOptions& options);

}  // namespace plumbline::training
