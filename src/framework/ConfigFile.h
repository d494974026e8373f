#pragma once
#include <map>
#include <memory>
#include <mutex>
#include <string>
#include <vector>

#include "framework/ConfigSection.h"

namespace plumbline {

/// One config file, read through its root(). `name` is looked for as DIRECTORY/name.yaml in each directory;
/// a later directory overrides single keys of an earlier one (lists as a whole) and says so
/// (ConfigOverlay.h). It must be in one of them.
///
///     ConfigFile file("Walk", {"config", "config/robots/type3"});
///     double height = file.root().get<double>("stepHeight", {0, 0.1});
///     file.checkUnknown();
class ConfigFile {
public:
  ConfigFile(const std::string& name, const std::vector<std::string>& directories);
  /// A single file by its path.
  explicit ConfigFile(const std::string& path);

  const ConfigSection& root() const { return root_; }
  /// Throws ConfigurationError for the first key nobody has asked for.
  void checkUnknown() const;

private:
  void load(const std::vector<std::string>& paths);

  std::shared_ptr<const ConfigNode> node_;
  ConfigSection root_;
};

/// The config files of an agent; each is read once and may be used by several modules.
class ConfigStore {
public:
  explicit ConfigStore(std::vector<std::string> directories) : directories_(std::move(directories)) {}

  /// The file `name`.yaml; throws ConfigurationError if it is in none of the directories.
  const ConfigFile& file(const std::string& name);
  /// True if `name`.yaml is in one of the directories.
  bool exists(const std::string& name) const;
  void checkUnknown() const;
  const std::vector<std::string>& directories() const { return directories_; }

private:
  std::vector<std::string> directories_;
  std::mutex mutex_;
  std::map<std::string, ConfigFile> files_;
};

}  // namespace plumbline
