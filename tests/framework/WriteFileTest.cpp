#include "framework/WriteFile.h"

#include <fcntl.h>
#include <gtest/gtest.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <unistd.h>

#include <csignal>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <stdexcept>

using plumbline::writeFile;

namespace {

TEST(WriteFile, replacesTheFileAndLeavesNoOther) {
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

TEST(WriteFile, doesNotReplaceADeviceOrAPipe) {
  const std::string pipe = testing::TempDir() + "write_file_pipe",
                    link = testing::TempDir() + "write_file_link";
  for (const std::string& path : {pipe, link}) std::filesystem::remove(path);
  ASSERT_EQ(mkfifo(pipe.c_str(), 0600), 0);
  std::filesystem::create_symlink(pipe, link);
  const int reader = open(pipe.c_str(), O_RDONLY | O_NONBLOCK | O_CLOEXEC);
  for (const std::string& path : {pipe, link}) {
    writeFile(path, "text");
    char got[8] = {};
    EXPECT_EQ(read(reader, got, sizeof got), 4);
    EXPECT_STREQ(got, "text");
    EXPECT_TRUE(std::filesystem::is_fifo(path)) << path;
  }
  EXPECT_TRUE(std::filesystem::is_symlink(link));
  close(reader);
  for (const std::string& path : {pipe, link}) std::filesystem::remove(path);
}

TEST(WriteFile, saysThatADeviceTakesNoMore) {
  const std::string link = testing::TempDir() + "write_file_full";  // and what replaced it would do no harm
  std::filesystem::remove(link);
  std::filesystem::create_symlink("/dev/full", link);
  try {
    writeFile(link, "x");
    ADD_FAILURE() << "written";
  } catch (const std::runtime_error& error) {
    EXPECT_EQ(error.what(), "cannot write " + link + ": No space left on device");
  }
  std::filesystem::remove(link);
}

/// 0 if a file that may not grow so far is left as it was, with the reason said.
int statusOfWritingTooMuch(const std::string& path) {
  signal(SIGXFSZ, SIG_IGN);
  const rlimit limit{1000, 1000};
  setrlimit(RLIMIT_FSIZE, &limit);
  try {
    writeFile(path, std::string(5000, 'x'));
  } catch (const std::runtime_error& error) {
    const bool said = error.what() == "cannot write " + path + ": File too large";
    const bool kept = std::filesystem::file_size(path) == 5;
    return said && kept && !std::filesystem::exists(path + ".part") ? 0 : 1;
  }
  return 2;
}

TEST(WriteFile, leavesTheOldFileWhereTheDiskIsFull) {
  try {
    writeFile("/dev/full/file", "x");
    FAIL() << "written";
  } catch (const std::runtime_error& error) {
    EXPECT_STREQ(error.what(), "cannot write /dev/full/file: Not a directory");
  }
  // A file may not grow beyond the limit: writing it fails in the middle.
  const std::string path = testing::TempDir() + "write_file_limit.txt";
  writeFile(path, "first");
  EXPECT_EXIT(_exit(statusOfWritingTooMuch(path)), testing::ExitedWithCode(0), "");
  std::filesystem::remove(path);
}

}  // namespace
