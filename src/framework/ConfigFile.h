#pragma once
#include <atomic>
#include <cstdint>
#include <map>
#include <memory>
#include <mutex>
#include <set>
#include <string>
#include <vector>

#include "framework/ConfigSection.h"

namespace plumbline {

/// One config file, read through its root(). `name` is looked for as DIRECTORY/name.yaml in each directory;
/// a later directory overrides single keys of an earlier one (lists as a whole) and says so
/// (ConfigOverlay.h). It must be in one of them.
///
///     ConfigFile file("Walk", {"config", "config/robots/simspark_type3"});
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
  /// What was asked for in the file as it was before counts as asked for here.
  void takeOver(const ConfigFile& before) const;

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
  /// The same for a module, which is noted as a reader of the file.
  const ConfigFile& file(const std::string& name, const std::string& reader);
  /// The files that a module has read itself, without its parameters.
  std::set<std::string> filesOf(const std::string& reader) const;
  /// True if `name`.yaml is in one of the directories.
  bool exists(const std::string& name) const;
  void checkUnknown() const;
  const std::vector<std::string>& directories() const { return directories_; }

  /// A file as it is on the disk now. While this lives, the thread that made it finds that one; kept, all
  /// do, otherwise the old one stays. Throws ConfigurationError for a file that cannot be read.
  class ChangedFile {
  public:
    ChangedFile(ConfigStore& store, const std::string& name);
    ~ChangedFile();
    ChangedFile(const ChangedFile&) = delete;
    ChangedFile& operator=(const ChangedFile&) = delete;
    void checkUnknown() const;
    void keep();

  private:
    friend class ConfigStore;
    ConfigStore& store_;
    std::string name_;
    std::map<std::string, ConfigFile> file_;  ///< none: the file is not there
  };

  /// Grows with each file that is kept.
  std::uint64_t version() const { return version_.load(std::memory_order_relaxed); }
  /// Files that were kept behind that version.
  std::vector<std::string> changedSince(std::uint64_t version) const;

private:
  static thread_local ChangedFile* changed_;

  std::vector<std::string> directories_;
  mutable std::mutex mutex_;
  std::map<std::string, ConfigFile> files_;
  std::vector<std::map<std::string, ConfigFile>::node_type> retired_;  ///< modules may still refer to them
  std::map<std::string, std::set<std::string>> readers_;               ///< files by module
  std::map<std::string, std::uint64_t> versions_;
  std::atomic<std::uint64_t> version_{0};
};

}  // namespace plumbline
