#include "modules/evaluation/PlayerFile.h"

#include <gtest/gtest.h>
#include <sys/resource.h>
#include <unistd.h>

#include <csignal>
#include <filesystem>
#include <vector>

#include "modules/evaluation/OutputProblems.h"
#include "support/ScratchFolder.h"
#include "support/Thrown.h"

namespace plumbline {
namespace {

class PlayerFileTest : public testing::Test {
protected:
  PlayerFileTest() { player.number = 3; }
  void write(const std::string& lines) { file.write(folder / "new", player, lines, problems); }
  test::ScratchFolder folder;
  PlayerInfo player;
  std::vector<std::string> said;
  OutputProblems problems{[this](const std::string& line) { said.push_back(line); }};
  PlayerFile file{"the words", "a,b"};
};

TEST_F(PlayerFileTest, isNamedAfterSideAndNumberAndBegunOnce) {
  player.leftSide = false;
  player.number = 7;
  for (int i = 0; i < 2; ++i) write("1,2\n");
  EXPECT_EQ(folder.read("new/right-7.csv"), "a,b\n1,2\n1,2\n");
  EXPECT_FALSE(problems.any());
}

TEST_F(PlayerFileTest, thatCannotBeIsSaidOnce) {
  folder.write("new/left-3.csv/in", "the way");
  for (int i = 0; i < 3; ++i) write("1,2\n");
  EXPECT_EQ(said, (std::vector<std::string>{"the words end here: " + folder / "new/left-3.csv" +
                                            ": cannot be written: Is a directory; make room, or choose "
                                            "another folder"}));
}

TEST_F(PlayerFileTest, onAFullDeviceTheFirstLineIsTheLast) {
  std::filesystem::create_directories(folder / "new");
  std::filesystem::create_symlink("/dev/full", folder / "new/left-3.csv");
  write("1,2\n");
  ASSERT_EQ(said.size(), 1u);
  EXPECT_NE(said[0].find(": No space left on device; "), std::string::npos) << said[0];
  EXPECT_TRUE(std::filesystem::exists(folder / "new/left-3.csv")) << "a device is no file to be removed";
}

/// What a file may not grow beyond, for the process of a death test.
void limitFiles(rlim_t bytes) {
  signal(SIGXFSZ, SIG_IGN);
  const rlimit limit{bytes, bytes};
  setrlimit(RLIMIT_FSIZE, &limit);
}

TEST_F(PlayerFileTest, endsWithAWholeLineWhereTheDiskIsFull) {
  const auto fillTheDisk = [this] {
    limitFiles(14);
    for (int i = 0; i < 9; ++i) write("1,2\n3,4\n");
    const bool whole = folder.read("new/left-3.csv") == "a,b\n1,2\n3,4\n";
    _exit(whole && said.size() == 1 && said[0].find("File too large") != std::string::npos ? 0 : 1);
  };
  EXPECT_EXIT(fillTheDisk(), testing::ExitedWithCode(0), "");
}

TEST_F(PlayerFileTest, ofWhichNoLineHasRoomIsNotThere) {
  const auto fillTheDisk = [this] {
    limitFiles(2);
    write("1,2\n");
    _exit(said.size() == 1 && !std::filesystem::exists(folder / "new/left-3.csv") ? 0 : 1);
  };
  EXPECT_EXIT(fillTheDisk(), testing::ExitedWithCode(0), "");
}

TEST_F(PlayerFileTest, isPreparedByMakingItsFolder) {
  PlayerFile::prepare(folder / "deep/new");
  EXPECT_TRUE(std::filesystem::is_directory(folder / "deep/new"));
  folder.write("deep/new/left-3.csv", "of the last game");
  folder.write("deep/new/notes.csv/in", "no player's");
  PlayerFile::prepare(folder / "deep/new");
  EXPECT_EQ(folder.read("deep/new/left-3.csv"), "of the last game");
}

TEST_F(PlayerFileTest, whatCannotBePreparedIsAnErrorAtOnce) {
  const std::string todo = "; choose another folder";
  EXPECT_EQ(thrownBy([&] { PlayerFile::prepare("/proc/nope"); }),
            "/proc/nope: cannot be written: No such file or directory" + todo);
  folder.write("file", "");
  EXPECT_EQ(thrownBy([&] { PlayerFile::prepare(folder / "file"); }),
            folder / "file" + ": cannot be written: Not a directory" + todo);
  folder.write("new/right-11.csv/in", "the way");
  EXPECT_EQ(thrownBy([&] { PlayerFile::prepare(folder / "new"); }),
            folder / "new/right-11.csv" + ": cannot be written: Is a directory" + todo);
}

}  // namespace
}  // namespace plumbline
