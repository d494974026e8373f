#pragma once
#include <memory>
#include <string>
#include <string_view>
#include <vector>

namespace plumbline {

/// One value of a config file with the place it comes from.
struct ConfigNode {
  enum class Kind { null, scalar, list, map };
  Kind kind = Kind::null;
  std::string text;     ///< of a scalar
  bool quoted = false;  ///< a scalar in quotes is a string, whatever it looks like
  struct Entry;
  std::vector<Entry> entries;        ///< of a map, in the file's order
  std::vector<ConfigNode> elements;  ///< of a list
  std::shared_ptr<const std::string> file;
  int line = 0;     ///< 0: not from a file
  std::string key;  ///< from the root of the file: `walk.stepHeight`, `skills[2].name`

  // Who asked for it: what was never asked for is an unknown key.
  mutable bool used = false;
  mutable std::vector<std::string> asked;  ///< of a map: the keys looked for in it

  const ConfigNode* find(std::string_view name) const;
  /// `file:line`
  std::string place() const { return *file + ":" + std::to_string(line); }
  /// What it is, for error texts: `"abc"`, `a list of 3`, `a map`, `empty`.
  std::string describe() const;
};

struct ConfigNode::Entry {
  std::string name;
  ConfigNode node;
};

/// Parses a YAML file. Throws ConfigurationError naming file and line: unreadable, broken, a key twice, a
/// second document, more than 4 MB or 100000 values.
ConfigNode loadYaml(const std::string& path);

/// One value written as in a YAML file: `0.5`, `[1, 2]`, `"a text"`. `name` is used for it in errors.
ConfigNode parseYamlValue(const std::string& text, const std::string& name);

}  // namespace plumbline
