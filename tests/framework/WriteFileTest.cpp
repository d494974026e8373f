#include "framework/WriteFile.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <sstream>
#include <stdexcept>

using plumbline::writeFile;

namespace {

TEST(WriteFile, replacesTheFileAndLeavesNothingBeside) {
  const std::string path = testing::TempDir() + "write_file.txt";
  writeFile(path, "first");
  writeFile(path, "second");
  std::stringstream content;
  content << std::ifstream(path).rdbuf();
  EXPECT_EQ(content.str(), "second");
  EXPECT_FALSE(std::filesystem::exists(path + ".part"));
}

TEST(WriteFile, saysWhatCannotBeWritten) {
  try {
    writeFile("/no/such/folder/file", "x");
    FAIL() << "written";
  } catch (const std::runtime_error& error) {
    EXPECT_STREQ(error.what(), "cannot write /no/such/folder/file: No such file or directory");
  }
}

}  // namespace
