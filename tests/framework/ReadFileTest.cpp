#include "framework/ReadFile.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>

namespace plumbline {
namespace {

constexpr std::size_t megabyte = 1 << 20;

std::string fileOf(const std::string& text) {
  std::string path = testing::TempDir() + "/readFile";
  std::ofstream(path, std::ios::binary) << text;
  return path;
}
std::string problem(const std::string& path) {
  try {
    readFile(path, megabyte);
  } catch (const FileProblem& error) {
    return error.what();
  }
  return "none";
}

TEST(ReadFile, hasAllBytes) {
  const std::string text("a\0b\r\n", 5);
  EXPECT_EQ(readFile(fileOf(text), megabyte), text);
  EXPECT_EQ(readFile(fileOf(""), megabyte), "");
  EXPECT_EQ(readFile(fileOf(std::string(megabyte, 'x')), megabyte).size(), megabyte);
}

TEST(ReadFile, saysWhyThereIsNoText) {
  EXPECT_EQ(problem(testing::TempDir() + "/nowhere"), "cannot be read: No such file or directory");
  EXPECT_EQ(problem(testing::TempDir()), "cannot be read: Is a directory");
  EXPECT_EQ(problem(fileOf(std::string(megabyte + 1, 'x'))), "is larger than 1 MB");
}

}  // namespace
}  // namespace plumbline
