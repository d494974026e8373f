#include "framework/ConfigOverlay.h"

#include <algorithm>
#include <filesystem>

#include "framework/ConfigSection.h"
#include "framework/ConfigurationError.h"
#include "framework/NearestName.h"

namespace plumbline {
namespace {

constexpr const char* overlayKey = "overlay";

bool isMap(const ConfigNode& node) { return node.kind == ConfigNode::Kind::map; }

/// How many values a map holds: all that is no map, a list as one. A key whose last line was lost holds none.
std::size_t countValues(const ConfigNode& node) {
  if (node.kind == ConfigNode::Kind::null) return 0;
  if (!isMap(node)) return 1;
  std::size_t count = 0;
  for (const auto& [key, child] : node.entries) count += countValues(child);
  return count;
}

/// The base's values that the other does not replace.
void collectKept(const ConfigNode& base, const ConfigNode* over, std::vector<std::string>& kept) {
  for (const auto& [key, child] : base.entries) {
    const ConfigNode* other = over && isMap(*over) ? over->find(key) : nullptr;
    if (isMap(child))
      collectKept(child, other, kept);
    else if (!other)
      kept.push_back(child.key);
  }
}

std::string baseNameOf(const ConfigNode& node) {
  return std::filesystem::path(*node.file).filename().string();
}

[[noreturn]] void fail(const ConfigNode& at, const std::string& what) {
  throw ConfigurationError(at.place() + ": " + what);
}

void checkDeclared(const ConfigNode& base, const ConfigNode& overlay, std::size_t values) {
  if (!isMap(overlay)) fail(overlay, "overlay must be " + overlayLine(baseNameOf(base), values).substr(9));
  for (const auto& [key, node] : overlay.entries)
    if (key != "base" && key != "values")
      fail(node, "unknown key \"" + node.key + "\"" + suggestion(key, {"base", "values"}));
  const ConfigNode *name = overlay.find("base"), *count = overlay.find("values");
  if (!name || !count) fail(overlay, "overlay needs base and values");
  std::string said;
  readConfig(*name, {}, said);
  if (said != baseNameOf(base))
    fail(*name, "overlay.base is " + said + ", but this file overrides " + *base.file);
  unsigned number = 0;
  readConfig(*count, {}, number);
  if (number != values)
    fail(*count, "overlay.values is " + std::to_string(number) + ", but there are " + std::to_string(values) +
                     " in the file: was a line lost or added? If not, write " + std::to_string(values));
}

void merge(ConfigNode& base, const ConfigNode& over) {
  if (!isMap(base) || !isMap(over)) {
    base = over;
    return;
  }
  for (const auto& [key, node] : over.entries) {
    ConfigNode* existing = nullptr;
    for (auto& entry : base.entries) {
      if (entry.name == key) existing = &entry.node;
    }
    if (existing) {
      merge(*existing, node);
    } else {
      base.entries.push_back({key, node});
    }
  }
}

}  // namespace

std::string overlayLine(const std::string& baseName, std::size_t values) {
  return std::string(overlayKey) + ": {base: " + baseName + ", values: " + std::to_string(values) + "}";
}

void layOver(ConfigNode& base, ConfigNode over) {
  const auto declared = std::find_if(over.entries.begin(), over.entries.end(),
                                     [](const ConfigNode::Entry& entry) { return entry.name == overlayKey; });
  if (declared != over.entries.end()) {
    const ConfigNode overlay = declared->node;
    over.entries.erase(declared);
    checkDeclared(base, overlay, countValues(over));
  } else {
    std::vector<std::string> kept;
    collectKept(base, &over, kept);
    if (!kept.empty())
      fail(over, "overrides " + *base.file + " but not " + std::to_string(kept.size()) + " of its values (" +
                     kept.front() + (kept.size() > 1 ? ", ..." : "") +
                     "); give these too, or begin the file with " +
                     overlayLine(baseNameOf(base), countValues(over)));
  }
  merge(base, over);
}

}  // namespace plumbline
