// Configuration in YAML: a file with another one over it, and single values as rdb sends them.
#include <vector>

#include "framework/ConfigFile.h"
#include "framework/ConfigNode.h"
#include "fuzz/Readers.h"

namespace plumbline::fuzz {
namespace {

constexpr std::size_t maxValues = 100000;  // as ConfigNode.h promises

void countValues(const ConfigNode& node, std::size_t& values, int depth) {
  require(++values <= maxValues, "more values than are taken");
  require(depth <= 33, "nested deeper than is taken");
  for (const ConfigNode::Entry& entry : node.entries) countValues(entry.node, values, depth + 1);
  for (const ConfigNode& element : node.elements) countValues(element, values, depth + 1);
}

/// A file, and what is laid over it.
void yamlFile(std::string_view bytes) {
  const auto [base, over] = halves(bytes);
  const std::string path = scratchFile("base/file.yaml", base);
  scratchFile("over/file.yaml", over);
  refusesInOneLine([&] {
    std::size_t values = 0;
    countValues(loadYaml(path), values, 0);
    const ConfigFile file("file", {scratchFolder() + "/base", scratchFolder() + "/over"});
    file.root().find<double>("number", {0, 10});
    file.root().find<std::string>("word");
    file.root().find<std::vector<std::vector<int>>>("table");
    if (file.root().has("map")) file.root().section("map").find<bool>("flag");
    if (file.root().has("list"))
      for (const ConfigSection& entry : file.root().list("list")) entry.find<double>("x");
    file.checkUnknown();
  });
}

void yamlValue(std::string_view bytes) {
  refusesInOneLine([&] {
    std::size_t values = 0;
    countValues(parseYamlValue(std::string(bytes), "value"), values, 0);
  });
}

std::vector<std::string> yamlFileSeeds() {
  std::string lists = "table: &a [1, 2]\n";
  for (char c = 'b'; c < 'g'; ++c)
    lists += std::string(1, c) + ": &" + c + " [*" + char(c - 1) + ", *" + char(c - 1) + ", *" + char(c - 1) +
             "]\n";
  return {
      "number: 1.5\nword: \"a # b\"\ntable: [[1, 2], [3]]\nmap: {flag: on}\nlist:\n  - x: 1\n  - {x: "
      "2}\n\n---8<---\n"
      "number: 2\n",
      lists,
      "a: &a [*a]\n",
      "number: !!float 3\nword: |\n  two\n  lines\n? [a]\n: b\n",
      "---\nnumber: 1\n---\nnumber: 2\n",
      contentOf("config/walking.yaml"),
      contentOf("config/field.yaml") + "\n---8<---\n" + contentOf("config/SkillGetBall.yaml"),
      std::string(60, '[')};
}
std::vector<std::string> yamlValueSeeds() {
  return {"0.5",         "[1, 2, [3, 4]]", "{a: 1, b: [x, y]}", "\"a text\"",
          "&a [*a, *a]", "!tag 3",         "--- 1\n--- 2\n",    "0x1F"};
}

const Registered yamlFileTarget({"yamlFile", yamlFile, yamlFileSeeds, 3000});
const Registered yamlValueTarget({"yamlValue", yamlValue, yamlValueSeeds, 12000});

}  // namespace
}  // namespace plumbline::fuzz
