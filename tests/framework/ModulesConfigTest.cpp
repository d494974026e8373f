#include "framework/ModulesConfig.h"

#include <gtest/gtest.h>

#include <cstdio>
#include <fstream>

#include "framework/ConfigurationError.h"

namespace plumbline {
namespace {

std::string problemWith(const std::string& text) {
  try {
    parseModulesConfig(text, "modules.cfg");
  } catch (const ConfigurationError& error) {
    return error.what();
  }
  return "no error";
}

TEST(ModulesConfigTest, readsThreadsAndLines) {
  const auto config = parseModulesConfig(
      "# two threads\r\n"
      "\n"
      "[thread1 5]\n"
      "Module1 Data # a comment\n"
      "  Module3\t\n"
      "[ thread2   15 ]\n"
      "thread1 Data\n"
      "Module2",
      "modules.cfg");
  ASSERT_EQ(config.threads.size(), 2u);
  EXPECT_EQ(config.threads[0].name, "thread1");
  EXPECT_EQ(config.threads[0].priority, 5);
  EXPECT_EQ(config.threads[0].line, 3);
  ASSERT_EQ(config.threads[0].lines.size(), 2u);
  EXPECT_EQ(config.threads[0].lines[0].line, 4);
  EXPECT_EQ(config.threads[0].lines[0].provider, "Module1");
  EXPECT_EQ(config.threads[0].lines[0].representation, "Data");
  EXPECT_EQ(config.threads[0].lines[1].provider, "Module3");
  EXPECT_EQ(config.threads[0].lines[1].representation, "");
  EXPECT_EQ(config.threads[1].name, "thread2");
  EXPECT_EQ(config.threads[1].priority, 15);
  ASSERT_EQ(config.threads[1].lines.size(), 2u);
  EXPECT_EQ(config.threads[1].lines[1].line, 8);
}

TEST(ModulesConfigTest, withoutASectionThereIsOneDefaultThread) {
  const auto config = parseModulesConfig("Module1 Data\nModule2\n", "modules.cfg");
  ASSERT_EQ(config.threads.size(), 1u);
  EXPECT_EQ(config.threads[0].name, "default");
  EXPECT_EQ(config.threads[0].lines.size(), 2u);
}

TEST(ModulesConfigTest, namesWhatIsNotOfTheForm) {
  const std::string form =
      "expected \"Module\", \"Module Representation\", \"thread Representation\" or \"[thread priority]\", "
      "not ";
  EXPECT_EQ(problemWith("A B\nA B C\n"), "modules.cfg:2: " + form + "\"A B C\"");
  EXPECT_EQ(problemWith("7up\n"), "modules.cfg:1: " + form + "\"7up\"");
  EXPECT_EQ(problemWith("A B-C\n"), "modules.cfg:1: " + form + "\"A B-C\"");
  EXPECT_EQ(problemWith("[main 1\nA\n"), "modules.cfg:1: " + form + "\"[main 1\"");
  EXPECT_EQ(problemWith("[]\nA\n"), "modules.cfg:1: " + form + "\"[]\"");
  EXPECT_EQ(problemWith("[a 1 2]\nA\n"), "modules.cfg:1: " + form + "\"[a 1 2]\"");
}

TEST(ModulesConfigTest, namesABadPriority) {
  EXPECT_EQ(problemWith("[main 16]\nA\n"),
            "modules.cfg:1: thread main needs a priority from 0 to 15, not \"16\"");
  EXPECT_EQ(problemWith("[main -1]\nA\n"),
            "modules.cfg:1: thread main needs a priority from 0 to 15, not \"-1\"");
  EXPECT_EQ(problemWith("[main high]\nA\n"),
            "modules.cfg:1: thread main needs a priority from 0 to 15, not \"high\"");
  EXPECT_EQ(problemWith("[main 99999999999]\nA\n"),
            "modules.cfg:1: thread main needs a priority from 0 to 15, not \"99999999999\"");
  EXPECT_EQ(problemWith("\n[main]\nA\n"), "modules.cfg:2: thread main needs a priority from 0 to 15");
}

TEST(ModulesConfigTest, namesMisplacedSections) {
  EXPECT_EQ(problemWith("A\n[main 1]\nB\n"),
            "modules.cfg:1: \"A\" stands before the first [thread priority]; put it below one");
  EXPECT_EQ(problemWith("[main 1]\nA\n[main 2]\nB\n"), "modules.cfg:3: thread main is already in line 1");
  EXPECT_EQ(problemWith("[main 1]\nA\n[other 2]\n"), "modules.cfg:3: thread other has no modules");
  EXPECT_EQ(problemWith("# nothing\n"), "modules.cfg: no modules");
  EXPECT_EQ(problemWith(""), "modules.cfg: no modules");
}

TEST(ModulesConfigTest, namesAFileThatCannotBeRead) {
  const auto errorOfFile = [](const std::string& path) -> std::string {
    try {
      readModulesConfig(path);
    } catch (const ConfigurationError& error) {
      return error.what();
    }
    return "no error";
  };
  EXPECT_EQ(errorOfFile("/nowhere/modules.cfg"),
            "/nowhere/modules.cfg: cannot be read: No such file or directory");
  EXPECT_EQ(errorOfFile("/tmp"), "/tmp: cannot be read: Is a directory");
  const std::string path = testing::TempDir() + "/large.cfg";
  std::ofstream(path) << std::string((1 << 20) + 1, '#');
  EXPECT_EQ(errorOfFile(path), path + ": larger than 1 MB");
  std::remove(path.c_str());
}

}  // namespace
}  // namespace plumbline
