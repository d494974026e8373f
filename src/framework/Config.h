#pragma once
#include <string>

#include "framework/ConfigSection.h"

namespace plumbline {

class ConfigStore;

/// A module's config values: the file config/<Module>.yaml, with overrides (see ConfigFile). Read them in
/// init(): when all modules have, keys nobody asked for are errors.
///
///     height_ = config.get<double>("walk.stepHeight", {0, 0.1});
///     for (const ConfigSection& skill : config.file("Skills").list("skills")) ...
class Config {
public:
  Config(ConfigStore& store, std::string name) : store_(store), name_(std::move(name)) {}

  /// See ConfigSection for what each of these does.
  template <typename T>
  T get(std::string_view key, Range range = {}) const {
    return own().get<T>(key, range);
  }
  template <typename T>
  T get(std::string_view key, double min, double max) const {
    return own().get<T>(key, Range{min, max});
  }
  template <typename T>
  std::optional<T> find(std::string_view key, Range range = {}) const {
    return own().find<T>(key, range);
  }
  bool has(std::string_view key) const { return own().has(key); }
  std::size_t choice(std::string_view key, const std::vector<std::string>& words) const {
    return own().choice(key, words);
  }
  ConfigSection section(std::string_view key) const { return own().section(key); }
  std::vector<ConfigSection> list(std::string_view key) const { return own().list(key); }
  std::vector<std::string> keys() const { return own().keys(); }
  [[noreturn]] void fail(std::string_view key, const std::string& message) const { own().fail(key, message); }

  /// Throws ConfigurationError "Module.key message", with file and line where a file sets the key.
  [[noreturn]] void refuse(const std::string& key, const std::string& message) const;

  /// The module's own file; it must exist.
  const ConfigSection& own() const { return file(name_); }
  /// Another file by its name without .yaml; several modules may read one.
  const ConfigSection& file(const std::string& name) const;
  /// True if a file of that name exists in one of the config directories.
  bool exists(const std::string& name) const;
  /// The directories files are looked for in, later ones override: for files that are not YAML.
  const std::vector<std::string>& directories() const;

private:
  ConfigStore& store_;
  std::string name_;
};

}  // namespace plumbline
