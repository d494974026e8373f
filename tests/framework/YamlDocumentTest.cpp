#include "framework/YamlDocument.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>

#include "framework/ConfigNode.h"
#include "framework/ConfigurationError.h"

namespace plumbline {
namespace {

std::string errorOf(const std::string& text) {
  try {
    parseYaml(text, "a.yaml");
  } catch (const ConfigurationError& error) {
    return error.what();
  }
  return "no error";
}

TEST(YamlDocument, readsOneDocument) {
  EXPECT_EQ(parseYaml("a: 1\nb: 2\n", "a.yaml")["b"].as<int>(), 2);
  EXPECT_EQ(parseYaml("---\na: 1\n", "a.yaml")["a"].as<int>(), 1);
  EXPECT_EQ(parseYaml("# a comment\n---\na: 1\n...\n", "a.yaml")["a"].as<int>(), 1);
  EXPECT_EQ(parseYaml("  a: 1\n  b: 2\n", "a.yaml")["b"].as<int>(), 2);
  EXPECT_TRUE(parseYaml("", "a.yaml").IsNull());
  EXPECT_TRUE(parseYaml("# a comment alone\n", "a.yaml").IsNull());
}

TEST(YamlDocument, refusesASecondDocument) {
  EXPECT_EQ(errorOf("a: 1\n---\nb: 2\n"),
            "a.yaml:2: a second document begins at ---; a file holds one: take this line out");
  EXPECT_EQ(errorOf("a: 1\nb:\n  c: 2\n--- # more\n"),
            "a.yaml:4: a second document begins at ---; a file holds one: take this line out");
  EXPECT_EQ(errorOf("---\na: 1\n---\nb: 2\n"),
            "a.yaml:3: a second document begins at ---; a file holds one: take this line out");
  EXPECT_EQ(errorOf("a: 1\n...\nb: 2\n"),
            "a.yaml:2: a second document begins at ...; a file holds one: take this line out");
  EXPECT_EQ(errorOf("---\n---\na: 1\n"),
            "a.yaml:2: a second document begins at ---; a file holds one: take this line out");
}

TEST(YamlDocument, refusesWhatAnIndentedFirstKeyCutsOff) {
  EXPECT_EQ(
      errorOf("# of type 4\n  ballX: 1\nballY: notanumber\nnonsense: 3\n"),
      "a.yaml:3: is indented less than the first key in line 2; all keys of a map begin in the same column");
}

TEST(YamlDocument, refusesBrokenYaml) {
  EXPECT_EQ(errorOf("a: [1\nb: 2\n"), "a.yaml:2: broken YAML: end of sequence flow not found");
  EXPECT_EQ(errorOf("a: 1\n---\nb: [\n").substr(0, 22), "a.yaml:4: broken YAML:");
}

TEST(YamlDocument, refusesLargeAndMissingFiles) {
  const std::string path = testing::TempDir() + "/large" + std::to_string(getpid()) + ".yaml";
  std::ofstream(path) << "a: " << std::string(2 << 20, 'x');
  const auto error = [](const std::string& file) -> std::string {
    try {
      readYaml(file, 1 << 20);
    } catch (const ConfigurationError& e) {
      return e.what();
    }
    return "no error";
  };
  EXPECT_EQ(error(path), path + ": is larger than 1 MB");
  std::filesystem::remove(path);
  EXPECT_EQ(error(path), path + ": cannot be read: No such file or directory");
}

}  // namespace
}  // namespace plumbline
