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
};

/// A section `[name priority]`.
struct ThreadConfig {
  static constexpr int maxPriority = 15;
  std::string name;
  int priority = 0;
  int line = 0;
  std::vector<ModulesConfigLine> lines;
};

/// modules.cfg as it is written; what the names mean is checked by ModuleGraph.
struct ModulesConfig {
  std::string path;
  std::vector<ThreadConfig> threads;

  /// Lines without any section make up one thread of this name.
  static constexpr const char* defaultThread = "default";
};

/// Throws ConfigurationError with file and line for what is not of the form modules.cfg has
/// (doc/reference/modules-cfg.md).
ModulesConfig parseModulesConfig(std::string_view text, const std::string& path);
ModulesConfig readModulesConfig(const std::string& path);

}  // namespace plumbline
