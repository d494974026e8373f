#include "modules/evaluation/PlayerFile.h"

#include <gtest/gtest.h>

#include "support/ScratchFolder.h"
#include "support/Thrown.h"

namespace plumbline {
namespace {

TEST(PlayerFile, isNamedAfterSideAndNumberAndBegunOnce) {
  const test::ScratchFolder folder;
  PlayerInfo player;
  player.leftSide = false;
  player.number = 7;
  {
    std::ofstream out;
    for (int i = 0; i < 2; ++i) {
      openPlayerFile(out, folder / "new", player, "a,b");
      out << "1,2\n";
    }
  }
  EXPECT_EQ(folder.read("new/right-7.csv"), "a,b\n1,2\n1,2\n");
}

TEST(PlayerFile, thatCannotBeIsAnError) {
  test::ScratchFolder folder;
  folder.write("left-3.csv/in", "the way");
  PlayerInfo player;
  player.number = 3;
  std::ofstream out;
  EXPECT_EQ(thrownBy([&] { openPlayerFile(out, folder / "", player, "a"); }),
            "cannot write " + folder / "" + "/left-3.csv");
}

}  // namespace
}  // namespace plumbline
