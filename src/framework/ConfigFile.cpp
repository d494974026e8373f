#include "framework/ConfigFile.h"

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

/// The unknown key that stands first in its file.
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
  for (std::size_t i = 1; i < paths.size(); i++) layOver(*node, loadYaml(paths[i]));
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

const ConfigFile& ConfigStore::file(const std::string& name) {
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
