#pragma once
#include <string>
#include <string_view>
#include <vector>

namespace plumbline {

/// A line `provider` or `provider representation` of modules.cfg; the provider is a module or a thread.
struct ModulesConfigLine {
  int line;
  std::string provider;
  std::string representation;  ///< empty: only executed
  std::string path{};          ///< of the file that has it
};

/// A section `[name priority]` or `[name priority rate]`.
struct ThreadConfig {
  static constexpr int maxPriority = 15;
  std::string name;
  int priority = 0;
  int line = 0;
  static constexpr double maxRate = 1e5;
  double rate = 0;  ///< cycles that it shall have per second [1/s]; 0: not stated
  std::vector<ModulesConfigLine> lines;
  std::string path{};  ///< of the file that the section begins in
  /// Among modules that could come next, the one that is earlier here comes first; empty: the
  /// lines decide alone. A replay keeps the order of its recording by it.
  std::vector<std::string> order{};
};

/// modules.cfg as it is written, with the files that it includes in their places; what the names mean is
/// checked by ModuleGraph.
struct ModulesConfig {
  std::string path;
  std::vector<ThreadConfig> threads;

  /// Lines without any section make up one thread of this name.
  static constexpr const char* defaultThread = "default";
};

/// Throws ConfigurationError with file and line for what is not of the form modules.cfg has
/// (doc/reference/modules-cfg.md). Files that it includes are looked for from the folder of `path`.
ModulesConfig parseModulesConfig(std::string_view text, const std::string& path);
ModulesConfig readModulesConfig(const std::string& path);

}  // namespace plumbline
