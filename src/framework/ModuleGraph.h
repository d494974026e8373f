#pragma once
#include <string>
#include <vector>

#include "framework/ModulesConfig.h"
#include "framework/Registry.h"

namespace plumbline {

/// A module in a thread with the representations it provides there, in the order of their lines.
struct ModulePlan {
  const ModuleLoader* loader;
  int line;  ///< the first one that names it
  std::vector<const ModuleOutput*> outputs;
  /// What it reads, with those of REQUIRES_ALL and USES_ALL one by one.
  std::vector<ModuleInput> inputs{};
  std::string path{};  ///< of the file with that line
};

/// A representation taken from another thread.
struct CopyPlan {
  std::string fromThread;
  const RepresentationLoader* representation;
  int line;
  std::string path;
};

/// A special module in a thread.
struct SpecialPlan {
  std::string name;
  std::vector<const RepresentationLoader*> representations;
  bool alone = false;  ///< has a line of its own, without a representation
};

/// What one thread does in a cycle.
struct ThreadPlan {
  std::string name;
  int priority;
  std::vector<CopyPlan> copies;
  std::vector<SpecialPlan> specials;
  /// In the order of execution: a module comes after all that provide what it requires. Among modules that
  /// could come next, the one that is first in modules.cfg does.
  std::vector<ModulePlan> modules;
  double rate = 0;  ///< cycles per second that modules.cfg states; 0: none

  /// Who provides the representation here, for people to read: a module, thread or special module. Empty:
  /// nobody.
  std::string provider(const std::string& representation) const;
};

/// One plan per thread, as modules.cfg wants it. Throws ConfigurationError with file and line for names
/// nobody knows, a missing provider, two providers, a cycle, a module in two threads, a copy that leads
/// nowhere (doc/reference/modules-cfg.md lists the texts).
std::vector<ThreadPlan> planThreads(const ModulesConfig& config,
                                    const Registry& registry = Registry::instance());

/// Sorts the modules of a thread (Kahn's algorithm, first line first). Throws ConfigurationError for a cycle.
void sortModules(ThreadPlan& thread);

}  // namespace plumbline
