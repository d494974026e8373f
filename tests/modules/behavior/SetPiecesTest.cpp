#include "modules/behavior/setpiece/SetPieces.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>

#include "framework/ConfigFile.h"
#include "support/Thrown.h"

using namespace plumbline;

namespace {

struct SetPiecesTest : testing::Test {
  SetPiecesTest() : folder(testing::TempDir() + "pieces" + std::to_string(getpid())) {
    std::filesystem::create_directories(folder + "/set_pieces");
  }
  ~SetPiecesTest() override { std::filesystem::remove_all(folder); }
  void write(const std::string& name, const std::string& text) const {
    std::ofstream(folder + "/set_pieces/" + name + ".yaml") << text;
  }
  SetPieces read() const {
    ConfigStore store({"config", folder});
    return SetPieces(Config(store, "Formation"));
  }
  std::string errorOf(const std::string& text) const {
    write("one", text);
    const std::string path = folder + "/set_pieces/one.yaml";
    std::string what = thrownBy([&] { readSetPiece("one", ConfigFile(path).root()); });
    for (std::size_t at; (at = what.find(folder)) != std::string::npos;) what.erase(at, folder.size() + 1);
    return what;
  }
  const std::string folder;
};

TEST_F(SetPiecesTest, placesOnTheFieldAreMirroredForABallOnTheRight) {
  const SetPiecePlace place{SetPiecePlace::Frame::field, 13, 1.5};
  EXPECT_EQ(place.at({15, 10}, 15, false), Vec2(13, 1.5));
  EXPECT_EQ(place.at({15, -10}, 15, true), Vec2(13, -1.5));
}

TEST_F(SetPiecesTest, placesFromTheBallGoAheadAndIntoTheField) {
  const SetPiecePlace place{SetPiecePlace::Frame::ball, 4, 3};
  EXPECT_EQ(place.at({2, 10}, 15, false), Vec2(6, 7));
  EXPECT_EQ(place.at({2, -10}, 15, true), Vec2(6, -7));
}

TEST_F(SetPiecesTest, placesTowardsTheOwnGoalLieOnTheLineToItsMiddle) {
  const SetPiecePlace wall{SetPiecePlace::Frame::ownGoal, 2, 0}, second{SetPiecePlace::Frame::ownGoal, 2, 1};
  EXPECT_TRUE(wall.at({0, 0}, 15, false).isApprox(Vec2(-2, 0)));
  EXPECT_TRUE(second.at({0, 0}, 15, false).isApprox(Vec2(-2, -1))) << "left of the way to the goal";
  const Vec2 ball(-11, 3);  // a triangle of 3, 4 and 5
  EXPECT_TRUE(wall.at(ball, 15, false).isApprox(ball + Vec2(-1.6, -1.2)));
  EXPECT_TRUE(wall.at({-11, -3}, 15, true).isApprox(Vec2(-12.6, -1.8)));
  EXPECT_TRUE(wall.at({-15, 0}, 15, false).allFinite());
}

TEST_F(SetPiecesTest, theProjectsOwnStayOnTheFieldWhereverTheBallLies) {
  ConfigStore store({"config"});
  const SetPieces pieces(Config(store, "Formation"));
  ASSERT_EQ(pieces.all().size(), 7U);
  for (const TeamPlayMode mode :
       {TeamPlayMode::kickOffOwn, TeamPlayMode::kickOffOpponent, TeamPlayMode::kickInOwn,
        TeamPlayMode::kickInOpponent, TeamPlayMode::cornerOwn, TeamPlayMode::cornerOpponent,
        TeamPlayMode::goalKickOwn, TeamPlayMode::goalKickOpponent, TeamPlayMode::freeKickOwn,
        TeamPlayMode::freeKickOpponent, TeamPlayMode::directFreeKickOwn, TeamPlayMode::directFreeKickOpponent,
        TeamPlayMode::passOpponent})
    EXPECT_NE(pieces.of(mode), nullptr);
  EXPECT_EQ(pieces.of(TeamPlayMode::playOn), nullptr);
  for (const TeamPlayMode mode :
       {TeamPlayMode::cornerOwn, TeamPlayMode::goalKickOwn, TeamPlayMode::kickOffOwn})
    for (const SetPiecePlace& place : pieces.of(mode)->places) {
      const Vec2 at = place.at({0, 0}, 15, false);
      EXPECT_LT(std::abs(at.x()), 15);
      EXPECT_LT(std::abs(at.y()), 10);
    }
}

TEST_F(SetPiecesTest, aFileOfALaterFolderIsTakenToo) {
  write("mine", "modes: [kickInOpponent]\n");
  EXPECT_NE(thrownBy([&] { read(); }).find("modes has a mode that mine.yaml has already"), std::string::npos);
}

TEST_F(SetPiecesTest, mistakesAreNamedWithTheirLine) {
  EXPECT_EQ(
      errorOf("modes: [cornerOwm]\n"),
      "set_pieces/one.yaml:1: modes has \"cornerOwm\", which is no play mode; did you mean \"cornerOwn\"?");
  EXPECT_EQ(errorOf("modes: []\n"), "set_pieces/one.yaml:1: modes must name a play mode");
  EXPECT_EQ(errorOf("modes: [cornerOwn]\nkick: [{x: 1, y: 2}]\nstand: [{x: 1, y: 2}]\n"),
            "set_pieces/one.yaml:3: stand and kick exclude each other: the striker kicks or waits");
  EXPECT_EQ(errorOf("modes: [cornerOwn]\nstand: [{x: 1, y: 2}, {x: 1, y: 2}]\n"),
            "set_pieces/one.yaml:2: stand must be 1 at most, not 2");
  EXPECT_EQ(errorOf("modes: [cornerOwn]\nplaces: [{ahead: 1}]\n"),
            "set_pieces/one.yaml:2: missing key \"places[0].inwards\"");
}

}  // namespace
