#pragma once
#include <map>
#include <memory>
#include <optional>
#include <string>

#include "optimization/Optimizers.h"
#include "optimization/Search.h"
#include "training/SearchTask.h"

namespace plumbline::training {

/// What is searched and how, as a configuration file says it (doc/how-to/optimise-a-motion.md).
struct Study {
  std::string task;
  TaskOptions options;
  std::string optimizer = "cmaes";
  OptimizerOptions search;
  Averaging averaging;
  std::vector<TaskParameter> parameters;  ///< the task's, with what the file changes in them

  /// The text of all that decides the results.
  std::string mark() const;
  SearchSpace space() const;
  Search makeSearch() const;
};

/// What a command line says in place of a study's file.
struct StudyChanges {
  std::map<std::string, std::string> options{};  ///< of the task
  std::optional<std::uint64_t> seed{};
};

/// Throws ConfigurationError, one line, for a file that cannot be used.
Study readStudy(const std::string& path, const StudyChanges& changes = {});

}  // namespace plumbline::training
