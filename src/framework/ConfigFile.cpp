#include "framework/ConfigFile.h"

#include <algorithm>
#include <filesystem>
#include <tuple>

#include "framework/ConfigNode.h"
#include "framework/ConfigOverlay.h"
#include "framework/ConfigurationError.h"
#include "framework/NearestName.h"

namespace plumbline {
namespace {

struct Unknown {
  const ConfigNode* node = nullptr;
  const ConfigNode* parent = nullptr;
  std::string name;
};

bool anyUsed(const ConfigNode& node) {
  if (node.used || !node.asked.empty()) return true;
  for (const auto& [name, child] : node.entries) {
    if (anyUsed(child)) return true;
  }
  return false;
}

/// The first unknown key in its file.
void collectUnknown(const ConfigNode& node, Unknown& first) {
  for (const ConfigNode& element : node.elements) {
    if (element.kind == ConfigNode::Kind::map) collectUnknown(element, first);
  }
  for (const auto& [name, child] : node.entries) {
    const bool usedMap = child.kind == ConfigNode::Kind::map && anyUsed(child);
    if (!usedMap && !child.used) {
      const auto order = [](const ConfigNode& n) { return std::tie(*n.file, n.line); };
      if (!first.node || order(child) < order(*first.node)) first = {&child, &node, name};
    } else if (usedMap || child.kind == ConfigNode::Kind::list) {
      collectUnknown(child, first);
    }
  }
}

std::vector<std::string> existing(const std::string& name, const std::vector<std::string>& directories) {
  std::vector<std::string> paths;
  for (const std::string& directory : directories) {
    std::string path = (std::filesystem::path(directory) / (name + ".yaml")).string();
    if (std::filesystem::exists(path)) paths.push_back(std::move(path));
  }
  return paths;
}

void takeOverMarks(const ConfigNode& before, const ConfigNode& now) {
  now.used = now.used || before.used;
  now.asked.insert(now.asked.end(), before.asked.begin(), before.asked.end());
  for (const auto& [name, child] : now.entries)
    if (const ConfigNode* same = before.find(name)) takeOverMarks(*same, child);
  for (std::size_t i = 0; i < std::min(now.elements.size(), before.elements.size()); ++i)
    takeOverMarks(before.elements[i], now.elements[i]);
}

std::string joined(const std::vector<std::string>& words) {
  std::string result;
  for (const std::string& word : words) result += (result.empty() ? "" : ", ") + word;
  return result;
}

}  // namespace

ConfigFile::ConfigFile(const std::string& name, const std::vector<std::string>& directories) {
  const std::vector<std::string> paths = existing(name, directories);
  if (paths.empty()) throw ConfigurationError("no config file " + name + ".yaml in " + joined(directories));
  load(paths);
}

ConfigFile::ConfigFile(const std::string& path) { load({path}); }

void ConfigFile::load(const std::vector<std::string>& paths) {
  auto node = std::make_shared<ConfigNode>(loadYaml(paths.front()));
  for (std::size_t i = 1; i < paths.size(); ++i) layOver(*node, loadYaml(paths[i]));
  node_ = node;
  root_ = ConfigSection(node_, *node_);
}

void ConfigFile::checkUnknown() const {
  Unknown unknown;
  collectUnknown(*node_, unknown);
  if (!unknown.node) return;
  throw ConfigurationError(unknown.node->place() + ": unknown key \"" + unknown.node->key + "\"" +
                           suggestion(unknown.name, unknown.parent->asked));
}

void ConfigFile::takeOver(const ConfigFile& before) const { takeOverMarks(*before.node_, *node_); }

thread_local ConfigStore::ChangedFile* ConfigStore::changed_ = nullptr;

ConfigStore::ChangedFile::ChangedFile(ConfigStore& store, const std::string& name)
    : store_(store), name_(name) {
  if (store.exists(name)) file_.emplace(name, ConfigFile(name, store.directories_));
  changed_ = this;
}

ConfigStore::ChangedFile::~ChangedFile() { changed_ = nullptr; }

void ConfigStore::ChangedFile::checkUnknown() const {
  if (file_.empty()) return;
  const ConfigFile& now = file_.begin()->second;
  {
    const std::lock_guard lock(store_.mutex_);
    if (const auto before = store_.files_.find(name_); before != store_.files_.end())
      now.takeOver(before->second);
  }
  now.checkUnknown();
}

void ConfigStore::ChangedFile::keep() {
  const std::lock_guard lock(store_.mutex_);
  // Files move with their addresses: who holds a part of one keeps it.
  if (auto old = store_.files_.extract(name_)) store_.retired_.push_back(std::move(old));
  if (!file_.empty()) store_.files_.insert(file_.extract(name_));
  store_.versions_[name_] = store_.version_ + 1;
  store_.version_++;
}

std::vector<std::string> ConfigStore::changedSince(std::uint64_t version) const {
  const std::lock_guard lock(mutex_);
  std::vector<std::string> names;
  for (const auto& [name, at] : versions_)
    if (at > version) names.push_back(name);
  return names;
}

const ConfigFile& ConfigStore::file(const std::string& name, const std::string& reader) {
  {
    const std::lock_guard lock(mutex_);
    readers_[reader].insert(name);
  }
  return file(name);
}

std::set<std::string> ConfigStore::filesOf(const std::string& reader) const {
  const std::lock_guard lock(mutex_);
  const auto found = readers_.find(reader);
  return found == readers_.end() ? std::set<std::string>() : found->second;
}

const ConfigFile& ConfigStore::file(const std::string& name) {
  if (changed_ && &changed_->store_ == this && changed_->name_ == name) {
    if (changed_->file_.empty()) ConfigFile gone(name, directories_);  // says where it was looked for
    return changed_->file_.at(name);
  }
  std::lock_guard lock(mutex_);
  const auto found = files_.find(name);
  if (found != files_.end()) return found->second;
  return files_.emplace(name, ConfigFile(name, directories_)).first->second;
}

bool ConfigStore::exists(const std::string& name) const { return !existing(name, directories_).empty(); }

void ConfigStore::checkUnknown() const {
  for (const auto& [name, file] : files_) file.checkUnknown();
}

}  // namespace plumbline
