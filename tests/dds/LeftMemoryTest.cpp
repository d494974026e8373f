#include "dds/LeftMemory.h"

#include <fcntl.h>
#include <gtest/gtest.h>
#include <sys/file.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>

namespace plumbline::dds {
namespace {

namespace fs = std::filesystem;

class LeftMemoryTest : public testing::Test {
protected:
  LeftMemoryTest() : folder(fs::path(testing::TempDir()) / ("left" + std::to_string(getpid()))) {
    fs::create_directories(folder);
  }
  ~LeftMemoryTest() override { fs::remove_all(folder); }

  /// A piece and the file of its lock, made so long ago.
  fs::path make(const std::string& name, std::chrono::minutes ago) const {
    for (const std::string& each : {name, name + "_el"}) {
      std::ofstream(folder / each) << "x";
      fs::last_write_time(folder / each, fs::file_time_type::clock::now() - ago);
    }
    return folder / name;
  }

  fs::path folder;
};

TEST_F(LeftMemoryTest, whatNobodyHoldsGoes) {
  const fs::path left = make("fastrtps_0123456789abcdef", std::chrono::minutes(5));
  const fs::path held = make("fastrtps_00000000000000aa", std::chrono::minutes(5));
  const fs::path young = make("fastrtps_00000000000000bb", std::chrono::minutes(0));
  const fs::path port = make("fastrtps_port7411", std::chrono::minutes(5));
  const fs::path other = make("fastrtps_0123456789abcdeF", std::chrono::minutes(5));
  const int lock = open((held.string() + "_el").c_str(), O_RDONLY | O_CLOEXEC);
  ASSERT_EQ(flock(lock, LOCK_EX | LOCK_NB), 0);
  EXPECT_EQ(removeLeftMemory(folder.string()), 1u);
  EXPECT_FALSE(fs::exists(left));
  EXPECT_FALSE(fs::exists(left.string() + "_el"));
  for (const fs::path& path : {held, young, port, other}) {
    EXPECT_TRUE(fs::exists(path)) << path;
    EXPECT_TRUE(fs::exists(path.string() + "_el")) << path;
  }
  close(lock);
  EXPECT_EQ(removeLeftMemory(folder.string()), 1u) << "its process has ended";
  EXPECT_FALSE(fs::exists(held));
}

TEST_F(LeftMemoryTest, aLinkIsNotFollowed) {
  const fs::path mine = folder / "mine";
  std::ofstream(mine) << "x";
  fs::last_write_time(mine, fs::file_time_type::clock::now() - std::chrono::minutes(5));
  fs::create_symlink(mine, folder / "fastrtps_0123456789abcdef_el");
  EXPECT_EQ(removeLeftMemory(folder.string()), 0u);
  EXPECT_TRUE(fs::exists(mine));
}

TEST_F(LeftMemoryTest, aFolderThatIsNotThereHoldsNothing) {
  EXPECT_EQ(removeLeftMemory((folder / "none").string()), 0u);
}

}  // namespace
}  // namespace plumbline::dds
