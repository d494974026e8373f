#pragma once
#include <cstddef>
#include <string>

namespace plumbline {

/// How much YAML a reader takes from anyone.
struct YamlLimits {
  std::size_t values = 100000;  ///< scalars, lists and maps, where an alias counts as all that it refers to
  int depth = 32;               ///< lists and maps within each other
};

/// Looks at a YAML text event by event, before yaml-cpp builds a tree of it: a few hundred bytes for each
/// value, and with aliases without end. Throws ConfigurationError "path:line: ..." for what is beyond the
/// limits, and YAML::Exception for what is no YAML.
void checkYamlLimits(const std::string& text, const std::string& path, const YamlLimits& limits = {});

}  // namespace plumbline
