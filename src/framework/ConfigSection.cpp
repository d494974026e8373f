#include "framework/ConfigSection.h"

#include <algorithm>
#include <charconv>
#include <cmath>

#include "framework/ConfigNode.h"
#include "framework/ConfigurationError.h"
#include "framework/NearestName.h"
#include "framework/SingleLine.h"

namespace plumbline {
namespace {

[[noreturn]] void failAt(const ConfigNode& node, const std::string& message) {
  const std::string place = node.line > 0 ? node.place() + ": " : "";
  throw ConfigurationError(singleLine(place + node.key + " " + message));
}

void use(const ConfigNode& node) {
  // Written only while it changes something, so that reading a value again from several threads is safe.
  if (!node.used) node.used = true;
}

template <typename T>
T parseNumber(const ConfigNode& node, const Range& range, const char* expected) {
  use(node);
  T value = 0;
  const char* start = node.text.data();
  const char* end = start + node.text.size();
  if (start != end && *start == '+') start++;
  const auto [stop, error] = std::from_chars(start, end, value);
  if (node.kind != ConfigNode::Kind::scalar || node.quoted || error != std::errc{} || stop != end ||
      !std::isfinite(static_cast<double>(value))) {
    failAt(node, "must be " + std::string(expected) + ", not " + node.describe());
  }
  const auto number = static_cast<double>(value);
  if (!range.contains(number)) failAt(node, "must be " + boundsText(range) + ", not " + node.text);
  return value;
}

}  // namespace

void readConfig(const ConfigNode& node, const Range&, bool& value) {
  use(node);
  if (node.kind != ConfigNode::Kind::scalar || node.quoted || (node.text != "true" && node.text != "false")) {
    failAt(node, "must be true or false, not " + node.describe());
  }
  value = node.text == "true";
}

void readConfig(const ConfigNode& node, const Range& range, int& value) {
  value = parseNumber<int>(node, range, "an integer");
}

void readConfig(const ConfigNode& node, const Range& range, unsigned& value) {
  value = parseNumber<unsigned>(node, range, "an integer not below 0");
}

void readConfig(const ConfigNode& node, const Range& range, std::int64_t& value) {
  value = parseNumber<std::int64_t>(node, range, "an integer");
}

void readConfig(const ConfigNode& node, const Range& range, float& value) {
  value = parseNumber<float>(node, range, "a number");
}

void readConfig(const ConfigNode& node, const Range& range, double& value) {
  value = parseNumber<double>(node, range, "a number");
}

void readConfig(const ConfigNode& node, const Range&, std::string& value) {
  use(node);
  if (node.kind != ConfigNode::Kind::scalar) failAt(node, "must be a text, not " + node.describe());
  value = node.text;
}

std::vector<const ConfigNode*> configElements(const ConfigNode& node, int size) {
  use(node);
  if (node.kind != ConfigNode::Kind::list ||
      (size >= 0 && node.elements.size() != static_cast<std::size_t>(size))) {
    failAt(node,
           "must be a list" + (size >= 0 ? " of " + std::to_string(size) : "") + ", not " + node.describe());
  }
  std::vector<const ConfigNode*> result;
  for (const ConfigNode& element : node.elements) result.push_back(&element);
  return result;
}

const ConfigNode* ConfigSection::optional(std::string_view key) const {
  const ConfigNode* node = map_;
  while (true) {
    const std::size_t dot = key.find('.');
    const std::string name(key.substr(0, dot));
    if (std::find(node->asked.begin(), node->asked.end(), name) == node->asked.end())
      node->asked.push_back(name);
    const ConfigNode* child = node->find(name);
    if (!child || dot == std::string_view::npos) return child;
    if (child->kind != ConfigNode::Kind::map) failAt(*child, "must be a map, not " + child->describe());
    node = child;
    key.remove_prefix(dot + 1);
  }
}

const ConfigNode& ConfigSection::required(std::string_view key) const {
  if (const ConfigNode* node = optional(key)) return *node;
  const std::string path = map_->key.empty() ? std::string(key) : map_->key + "." + std::string(key);
  // A misspelt key is both missing and unknown: name the line it is in.
  const ConfigNode* parent = map_;
  std::string_view name = key;
  for (std::size_t dot = name.find('.'); dot != std::string_view::npos; dot = name.find('.')) {
    const ConfigNode* child = parent->find(name.substr(0, dot));
    if (!child) break;
    parent = child;
    name.remove_prefix(dot + 1);
  }
  name = name.substr(0, name.find('.'));
  std::vector<std::string> others;
  for (const auto& [other, node] : parent->entries) {
    if (std::find(parent->asked.begin(), parent->asked.end(), other) == parent->asked.end())
      others.push_back(other);
  }
  const std::string nearest = nearestName(name, others);
  std::string hint;
  if (!nearest.empty()) {
    const ConfigNode* node = parent->find(nearest);
    hint = "; is it \"" + nearest + "\" in line " + std::to_string(node->line) + "?";
  }
  throw ConfigurationError(parent->place() + ": missing key \"" + path + "\"" + hint);
}

std::size_t ConfigSection::choice(std::string_view key, const std::vector<std::string>& words) const {
  const ConfigNode& node = required(key);
  std::string word;
  readConfig(node, {}, word);
  std::string all;
  for (std::size_t i = 0; i < words.size(); ++i) {
    if (words[i] == word) return i;
    all += (i == 0 ? "" : i + 1 < words.size() ? ", " : " or ") + words[i];
  }
  failAt(node, "must be " + all + ", not " + node.describe());
}

ConfigSection ConfigSection::section(std::string_view key) const {
  const ConfigNode& node = required(key);
  if (node.kind != ConfigNode::Kind::map) failAt(node, "must be a map, not " + node.describe());
  use(node);
  return ConfigSection(root_, node);
}

std::vector<ConfigSection> ConfigSection::list(std::string_view key) const {
  std::vector<ConfigSection> result;
  for (const ConfigNode* element : configElements(required(key))) {
    if (element->kind != ConfigNode::Kind::map) failAt(*element, "must be a map, not " + element->describe());
    result.emplace_back(root_, *element);
  }
  return result;
}

std::vector<std::string> ConfigSection::keys() const {
  std::vector<std::string> result;
  for (const auto& [name, node] : map_->entries) result.push_back(name);
  return result;
}

void ConfigSection::fail(std::string_view key, const std::string& message) const {
  failAt(required(key), message);
}

}  // namespace plumbline
