#include "framework/ModulesConfig.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <cstdio>
#include <filesystem>
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

TEST(ModulesConfigTest, aThreadMayStateItsRate) {
  const auto config = parseModulesConfig("[one 3 100Hz]\nA\n[two 3]\nB\n[three 3 12.5Hz]\nC\n", "m");
  EXPECT_EQ(config.threads[0].rate, 100);
  EXPECT_EQ(config.threads[1].rate, 0);
  EXPECT_EQ(config.threads[2].rate, 12.5);
  const std::string start =
      "modules.cfg:1: thread one: a rate is a number of Hz up to 100000, as 100Hz, not ";
  for (const std::string rate : {"100", "Hz", "0Hz", "-5Hz", "nanHz", "infHz", "1e9Hz", "5Hzz"})
    EXPECT_EQ(problemWith("[one 3 " + rate + "]\nA\n"), start + '"' + rate + '"');
}

TEST(ModulesConfigTest, namesWhatIsNotOfTheForm) {
  const std::string form =
      "expected \"Module\", \"Module Representation\", \"thread Representation\", \"include FILE\" or "
      "\"[thread priority]\", not ";
  EXPECT_EQ(problemWith("A B\nA B C\n"), "modules.cfg:2: " + form + "\"A B C\"");
  EXPECT_EQ(problemWith("7up\n"), "modules.cfg:1: " + form + "\"7up\"");
  EXPECT_EQ(problemWith("A B-C\n"), "modules.cfg:1: " + form + "\"A B-C\"");
  EXPECT_EQ(problemWith("[main 1\nA\n"), "modules.cfg:1: " + form + "\"[main 1\"");
  EXPECT_EQ(problemWith("[]\nA\n"), "modules.cfg:1: " + form + "\"[]\"");
  EXPECT_EQ(problemWith("[a 1 2Hz 3]\nA\n"), "modules.cfg:1: " + form + "\"[a 1 2Hz 3]\"");
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
            "modules.cfg:1: \"A\" comes before the first [thread priority]; put it below one");
  EXPECT_EQ(problemWith("[main 1]\nA\n[main 2]\nB\n"), "modules.cfg:3: thread main is already in line 1");
  EXPECT_EQ(problemWith("[main 1]\nA\n[other 2]\n"), "modules.cfg:3: thread other has no modules");
  EXPECT_EQ(problemWith("# nothing\n"), "modules.cfg: no modules");
  EXPECT_EQ(problemWith(""), "modules.cfg: no modules");
}

/// Files in a folder of their own.
class ModulesConfigFiles : public testing::Test {
protected:
  ModulesConfigFiles()
      : folder((std::filesystem::temp_directory_path() / ("modules" + std::to_string(getpid()))).string()) {
    std::filesystem::create_directories(folder + "/shared");
  }
  ~ModulesConfigFiles() override { std::filesystem::remove_all(folder); }
  void write(const std::string& name, const std::string& text) const {
    std::ofstream(folder + "/" + name) << text;
  }
  std::string problem() const {
    try {
      readModulesConfig(folder + "/modules.cfg");
    } catch (const ConfigurationError& error) {
      return error.what();
    }
    return "no error";
  }
  const std::string folder;
};

TEST_F(ModulesConfigFiles, anIncludedFileStandsInThePlaceOfItsLine) {
  write("modules.cfg", "[main 1]\nFirst A\ninclude shared/more.cfg  # a comment\nLast Z\n");
  write("shared/more.cfg", "Second B\ninclude even_more.cfg\n");
  write("shared/even_more.cfg", "\nThird C\n[other 2]\n");
  const ModulesConfig config = readModulesConfig(folder + "/modules.cfg");
  ASSERT_EQ(config.threads.size(), 2u);
  std::string lines;
  for (const ThreadConfig& thread : config.threads)
    for (const ModulesConfigLine& line : thread.lines)
      lines += thread.name + " " + line.provider + " " + line.path.substr(folder.size() + 1) + ":" +
               std::to_string(line.line) + "\n";
  EXPECT_EQ(lines,
            "main First modules.cfg:2\nmain Second shared/more.cfg:1\nmain Third shared/even_more.cfg:2\n"
            "other Last modules.cfg:4\n");
}

TEST_F(ModulesConfigFiles, errorsNameTheIncludedFileAndItsLine) {
  write("modules.cfg", "First A\ninclude shared/more.cfg\n");
  const std::string more = folder + "/shared/more.cfg";
  write("shared/more.cfg", "\nSecond B C\n");
  EXPECT_EQ(problem().substr(0, more.size() + 12), more + ":2: expected");
  write("shared/more.cfg", "[late 1]\nSecond B\n");
  EXPECT_EQ(problem(),
            folder + "/modules.cfg:1: \"First\" comes before the first [thread priority]; put it below one");
  write("shared/more.cfg", "include ../modules.cfg\n");
  EXPECT_EQ(problem(), more + ":1: include " + folder + "/modules.cfg: a file cannot include itself");
  write("shared/more.cfg", "include\n");
  EXPECT_EQ(problem(), more + ":1: include names one file: include FILE");
  write("shared/more.cfg", "include nowhere.cfg\n");
  EXPECT_EQ(problem(), more + ":1: include " + folder +
                           "/shared/nowhere.cfg: cannot be read: No such file or directory");
  write("modules.cfg", "[main 1]\nFirst A\ninclude shared/more.cfg\n");
  write("shared/more.cfg", "[main 2]\nSecond B\n");
  EXPECT_EQ(problem(), more + ":1: thread main is already in " + folder + "/modules.cfg:1");
  std::string many;
  for (int i = 0; i < 101; ++i) many += "include shared/more.cfg\n";
  write("modules.cfg", many);
  write("shared/more.cfg", "Second B\n");
  EXPECT_EQ(problem(), folder + "/modules.cfg:101: include " + more + ": more than 100 files are included");
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
  EXPECT_EQ(errorOfFile(path), path + ": is larger than 1 MB");
  std::remove(path.c_str());
}

}  // namespace
}  // namespace plumbline
