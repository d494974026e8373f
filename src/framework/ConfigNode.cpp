#include "framework/ConfigNode.h"

#include "framework/ConfigurationError.h"
#include "framework/SingleLine.h"
#include "framework/YamlDocument.h"
#include "framework/YamlLimits.h"

namespace plumbline {
namespace {

constexpr std::size_t maxFileSize = 4 << 20;
constexpr std::size_t maxNodes = 100000;
constexpr unsigned maxDepth = 32;

class Converter {
public:
  explicit Converter(std::shared_ptr<const std::string> file) : file_(std::move(file)) {}

  ConfigNode convert(const YAML::Node& yaml, const std::string& path, int parentLine, unsigned depth) {
    ConfigNode node;
    node.key = path;
    node.file = file_;
    node.line = yaml.Mark().line >= 0 ? yaml.Mark().line + 1 : parentLine;
    // Aliases can make a small file unfold without end.
    if (++nodes_ > maxNodes) fail(node.line, "more than " + std::to_string(maxNodes) + " values");
    if (depth > maxDepth) fail(node.line, "nested deeper than " + std::to_string(maxDepth) + " levels");
    switch (yaml.Type()) {
      case YAML::NodeType::Scalar:
        node.kind = ConfigNode::Kind::scalar;
        node.text = yaml.Scalar();
        node.quoted = yaml.Tag() == "!";
        break;
      case YAML::NodeType::Sequence:
        node.kind = ConfigNode::Kind::list;
        for (const auto& element : yaml) {
          const std::string elementPath = path + "[" + std::to_string(node.elements.size()) + "]";
          node.elements.push_back(convert(element, elementPath, node.line, depth + 1));
        }
        break;
      case YAML::NodeType::Map:
        node.kind = ConfigNode::Kind::map;
        for (const auto& entry : yaml) {
          const int line = entry.first.Mark().line + 1;
          if (!entry.first.IsScalar()) fail(line, "a key must be a plain word");
          const std::string& key = entry.first.Scalar();
          if (key != singleLine(key)) fail(line, "a key must be a plain word");
          if (key.find('.') != std::string::npos) {
            fail(line, "key \"" + key + "\" contains a dot; nest the keys instead");
          }
          if (const ConfigNode* first = node.find(key)) {
            fail(line, "key \"" + key + "\" is already in line " + std::to_string(first->line));
          }
          const std::string entryPath = path.empty() ? key : path + "." + key;
          node.entries.push_back({key, convert(entry.second, entryPath, line, depth + 1)});
          node.entries.back().node.line = line;
        }
        break;
      default:
        break;
    }
    return node;
  }

private:
  [[noreturn]] void fail(int line, const std::string& message) const {
    throw ConfigurationError(*file_ + ":" + std::to_string(line) + ": " + message);
  }

  std::shared_ptr<const std::string> file_;
  std::size_t nodes_ = 0;
};

}  // namespace

const ConfigNode* ConfigNode::find(std::string_view wanted) const {
  for (const auto& [name, node] : entries) {
    if (name == wanted) return &node;
  }
  return nullptr;
}

std::string ConfigNode::describe() const {
  switch (kind) {
    case Kind::scalar:
      return "\"" + singleLine(text.substr(0, 40)) + "\"";
    case Kind::list:
      return "a list of " + std::to_string(elements.size());
    case Kind::map:
      return "a map";
    default:
      return "empty";
  }
}

ConfigNode loadYaml(const std::string& path) {
  const YAML::Node yaml = readYaml(path, maxFileSize);
  ConfigNode root = Converter(std::make_shared<const std::string>(path)).convert(yaml, "", 1, 0);
  root.line = 1;
  if (root.kind == ConfigNode::Kind::null) root.kind = ConfigNode::Kind::map;
  if (root.kind != ConfigNode::Kind::map) {
    throw ConfigurationError(path + ":1: expected lines of the form \"key: value\"");
  }
  return root;
}

ConfigNode parseYamlValue(const std::string& text, const std::string& name) {
  if (text.size() > maxFileSize) throw ConfigurationError(name + ": longer than 4 MB");
  try {
    checkYamlLimits(text, name);
    const auto documents = YAML::LoadAll(text);
    if (documents.size() > 1) throw ConfigurationError(name + " takes one value");
    const YAML::Node yaml = documents.empty() ? YAML::Node() : documents.front();
    ConfigNode node = Converter(std::make_shared<const std::string>("value")).convert(yaml, name, 1, 0);
    node.line = 0;
    return node;
  } catch (const YAML::Exception& error) {
    throw ConfigurationError(name + ": broken YAML: " + singleLine(error.msg));
  }
}

}  // namespace plumbline
