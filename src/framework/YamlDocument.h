#pragma once
#include <yaml-cpp/yaml.h>

#include <string>

namespace plumbline {

/// The one document of a YAML text; `path` is named in errors. Every reader of YAML goes through this,
/// because yaml-cpp's own Load ignores all that follows the first document: what comes after a `---`, and all
/// lines below an indented first key. Null for an empty text. Throws ConfigurationError `path:line: ...`.
YAML::Node parseYaml(const std::string& text, const std::string& path);

/// Reads a file's text and parses it. Throws ConfigurationError, also if it cannot be read or is larger than
/// maxBytes.
YAML::Node readYaml(const std::string& path, std::size_t maxBytes);

}  // namespace plumbline
