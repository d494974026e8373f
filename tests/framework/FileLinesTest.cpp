#include "framework/FileLines.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <vector>

namespace plumbline {
namespace {

std::string fileOf(const std::string& text) {
  std::string path = testing::TempDir() + "/fileLines";
  std::ofstream(path, std::ios::binary) << text;
  return path;
}
std::vector<std::string> linesOf(const std::string& text, std::streamoff from = 0) {
  FileLines lines(fileOf(text), from);
  std::vector<std::string> all;
  for (std::string line; lines.next(line);) all.push_back(line);
  return all;
}
/// Where the next line begins after each line, and whether it had an end.
std::vector<std::pair<std::streamoff, bool>> endsOf(const std::string& text) {
  FileLines lines(fileOf(text));
  std::vector<std::pair<std::streamoff, bool>> ends;
  for (std::string line; lines.next(line);) ends.emplace_back(lines.end(), lines.whole());
  return ends;
}
/// Without the file's name.
std::string problemOfLines(const std::string& path) {
  try {
    FileLines lines(path);
    for (std::string line; lines.next(line);) continue;
  } catch (const std::runtime_error& error) {
    return std::string(error.what()).substr(path.size());
  }
  return "none";
}
using Lines = std::vector<std::string>;
using Ends = std::vector<std::pair<std::streamoff, bool>>;

TEST(FileLines, hasAllLines) {
  EXPECT_EQ(linesOf(""), Lines());
  EXPECT_EQ(linesOf("one\n\nthree"), (Lines{"one", "", "three"}));
  EXPECT_EQ(linesOf("one\r\ntwo\n"), (Lines{"one\r", "two"}));
  EXPECT_EQ(linesOf("one\ntwo\nthree\n", 4), (Lines{"two", "three"}));
  EXPECT_EQ(linesOf("one\n", 40), Lines());
}

TEST(FileLines, knowsWhereALineEnds) {
  EXPECT_EQ(endsOf("one\n\ntwo"), (Ends{{4, true}, {5, true}, {8, false}}));
}

TEST(FileLines, saysWhyThereAreNone) {
  EXPECT_EQ(problemOfLines(testing::TempDir() + "/nowhere"), ": cannot be read: No such file or directory");
  EXPECT_EQ(problemOfLines(testing::TempDir()), ": cannot be read: Is a directory");
  EXPECT_EQ(problemOfLines("/proc/self/mem"), ": cannot be read: Input/output error");
}

}  // namespace
}  // namespace plumbline
