#include "watch/TrackReader.h"

#include <gtest/gtest.h>

#include <fstream>

#include "support/Thrown.h"

using namespace plumbline;

namespace {

constexpr const char* head = "time,side,number,x,y,up,mode\n";

std::string fileOf(const std::string& text) {
  const std::string path = testing::TempDir() + "track.csv";
  std::ofstream(path) << text;
  return path;
}

TEST(TrackReaderTest, readsMomentsWithTheirPlayers) {
  const auto moments =
      watch::readTrack(fileOf(std::string(head) + "0.10,ball,0,1.00,-2.00,0,KickOff_Left\n"
                                                  "0.10,left,1,-14.40,-0.05,1.00,KickOff_Left\n"
                                                  "0.10,right,2,3.00,0.50,0.10,KickOff_Left\n"
                                                  "0.60,ball,0,1.50,-2.00,0,PlayOn\n"));
  ASSERT_EQ(moments.size(), 2u);
  EXPECT_EQ(moments[0].ball, Vec2(1, -2));
  ASSERT_EQ(moments[0].players.size(), 2u);
  EXPECT_TRUE(moments[0].players[0].left && moments[0].players[0].stands);
  EXPECT_EQ(moments[0].players[1].number, 2);
  EXPECT_FALSE(moments[0].players[1].left || moments[0].players[1].stands);
  EXPECT_EQ(moments[1].mode, "PlayOn");
}

TEST(TrackReaderTest, itsErrorsSayWhereAndWhat) {
  const std::string path = testing::TempDir() + "track.csv";
  const auto errorOf = [](const std::string& text) {
    return thrownBy([&] { watch::readTrack(fileOf(text)); });
  };
  EXPECT_EQ(errorOf("a,b,c,d,e,f,g\n"), path + ":1: is no track of a game: its first line differs");
  EXPECT_EQ(errorOf(std::string(head) + "0.1,ball,0,1\n"), path + ":2: must have 7 columns");
  EXPECT_EQ(errorOf(std::string(head) + "0.1,ball,0,nan,0,0,PlayOn\n"),
            path + ":2: 'nan' is no number within 1000");
  EXPECT_EQ(errorOf(std::string(head) + "0.1,left,1,0,0,1,PlayOn\n"),
            path + ":2: a player before the first ball");
  EXPECT_EQ(errorOf(std::string(head) + "0.5,ball,0,0,0,0,PlayOn\n0.5,ball,0,0,0,0,PlayOn\n"),
            path + ":3: the time does not rise");
  EXPECT_EQ(thrownBy([] { watch::readTrack("/nowhere/track.csv"); }),
            "/nowhere/track.csv: cannot be read: No such file or directory");
}

}  // namespace
