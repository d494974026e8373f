#include "watch/GameCounter.h"

#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <thread>

#include "watch/GameWatch.h"

namespace plumbline::watch {
namespace {

using simspark::SceneRobot;
using simspark::SceneState;
using simspark::TeamSide;

SceneRobot robot(TeamSide side, int unum, Vec2 place, double lean = 0) {
  SceneRobot robot;
  robot.side = side;
  robot.unum = unum;
  robot.T_world_torso.translation() = Vec3(place.x(), place.y(), 0.385);
  robot.T_world_torso.linear() = Eigen::AngleAxisd(lean, Vec3::UnitY()).toRotationMatrix();
  return robot;
}

/// A game in which time passes by 0.1 s a scene.
class Game : public testing::Test {
protected:
  Game() {
    scene.playMode = "PlayOn";
    scene.robots = {robot(TeamSide::left, 1, {0, 0}), robot(TeamSide::right, 2, {2, 0})};
    scene.ball = Vec3(0.2, 0, 0.042);
    counter.observe(scene);
  }
  void step(Vec2 ballVelocity = Vec2::Zero()) {
    scene.time += 0.1;
    scene.ball.head<2>() += 0.1 * ballVelocity;
    counter.observe(scene);
  }
  void lean(int who, double angle) {
    scene.robots[static_cast<std::size_t>(who)].T_world_torso.linear() =
        Eigen::AngleAxisd(angle, Vec3::UnitY()).toRotationMatrix();
    step();
  }
  SceneState scene;
  GameCounter counter;
};

TEST_F(Game, aFallIsCountedOnceUntilTheRobotStandsAgain) {
  lean(0, 0);
  lean(0, 1.0);  // leans, but less than 60 degrees
  EXPECT_EQ(counter.falls(TeamSide::left), 0);
  lean(0, 1.1);
  EXPECT_EQ(counter.falls(TeamSide::left), 1);
  lean(0, 0.9);  // half way up, and down again: the same fall
  lean(0, 1.5);
  EXPECT_EQ(counter.falls(TeamSide::left), 1);
  lean(0, 0.1);
  lean(0, -1.5);
  EXPECT_EQ(counter.falls(TeamSide::left), 2);
  EXPECT_EQ(counter.falls(TeamSide::right), 0);
  lean(1, 2);
  EXPECT_EQ(counter.falls(TeamSide::right), 1);
}

TEST_F(Game, whoLiesFromTheBeginningOrFallsBeforeKickOffHasNotFallen) {
  scene.robots.push_back(robot(TeamSide::left, 3, {5, 5}, 1.5));
  step();
  EXPECT_EQ(counter.falls(TeamSide::left), 0);
  scene.playMode = "BeforeKickOff";
  lean(1, 0);
  lean(1, 1.5);
  scene.playMode = "KickOff_Left";
  lean(1, 1.5);
  EXPECT_EQ(counter.falls(TeamSide::right), 0);
  EXPECT_EQ(counter.players(TeamSide::left), 2);
  EXPECT_EQ(counter.players(TeamSide::right), 1);
}

TEST_F(Game, aKickIsTheNearestRobots) {
  step();
  step({5, 0});
  EXPECT_EQ(counter.kicks(TeamSide::left), 1);
  for (int i = 0; i < 3; ++i) step({4, 0});  // it rolls to the right robot
  step({0.2, 0});
  step({0, 0});
  step({-3, 0});
  EXPECT_EQ(counter.kicks(TeamSide::right), 1);
  EXPECT_EQ(counter.kicks(TeamSide::left), 1);
}

TEST_F(Game, whatIsNoKick) {
  step();
  step({1.4, 0});  // pushed in walking
  step({0, 0});
  EXPECT_EQ(counter.kicks(TeamSide::left), 0);
  step({100, 0});  // carried by the referee to 10 m
  step({0, 0});
  EXPECT_EQ(counter.kicks(TeamSide::left), 0);
  step({5, 0});  // nobody is there
  EXPECT_EQ(counter.kicks(TeamSide::left) + counter.kicks(TeamSide::right), 0);
}

TEST_F(Game, theSwingOfOneKickCountsOnce) {
  step();
  step({2, 0});
  step({6, 0});
  EXPECT_EQ(counter.kicks(TeamSide::left), 1);
}

TEST_F(Game, aClockThatStandsIsNoTime) {
  step();
  scene.ball = Vec3(0.3, 0, 0.042);
  counter.observe(scene);  // the same time: nothing has a speed
  step();
  EXPECT_EQ(counter.kicks(TeamSide::left), 0);
}

TEST_F(Game, foulsAreCountedByTeamAndKind) {
  using simspark::FoulKind;
  scene.fouls = {{1, FoulKind::charging, TeamSide::left, 1}, {2, FoulKind::touching, TeamSide::right, 1}};
  step();
  // Told again while the player is held; another player's is another foul.
  scene.fouls = {{3, FoulKind::charging, TeamSide::left, 1}, {4, FoulKind::charging, TeamSide::left, 1}};
  step();
  scene.fouls = {{5, FoulKind::charging, TeamSide::left, 2}};
  step();
  scene.fouls.clear();
  step();
  scene.fouls = {{6, FoulKind::charging, TeamSide::left, 1}};
  step();
  EXPECT_EQ(counter.fouls(TeamSide::left, FoulKind::charging), 3);
  EXPECT_EQ(counter.fouls(TeamSide::right, FoulKind::touching), 1);
  EXPECT_EQ(counter.fouls(TeamSide::right, FoulKind::charging), 0);
}

TEST_F(Game, aFreeKickIsAgainstTheOtherTeam) {
  for (const char* mode :
       {"PlayOn", "free_kick_right", "free_kick_right", "PlayOn", "direct_free_kick_right"}) {
    scene.playMode = mode;
    step();
  }
  EXPECT_EQ(counter.freeKicksAgainst(TeamSide::left), 2);
  EXPECT_EQ(counter.freeKicksAgainst(TeamSide::right), 0);
}

TEST_F(Game, aShotIsInTheLog) {
  scene.robots = {robot(TeamSide::left, 1, {11.8, 0}), robot(TeamSide::right, 2, {-5, 0})};
  scene.ball = Vec3(12, 0, 0.042);
  for (int i = 0; i < 5; ++i) step();
  for (int i = 0; i < 5; ++i) step({4, 0});
  EXPECT_EQ(counter.shots(TeamSide::left), 1);
  EXPECT_EQ(counter.shots(TeamSide::right), 0);
  GameResult result;
  result.counts = counter;
  const std::string line = gameLogLine({}, result);
  EXPECT_EQ(line.substr(line.size() - 4), ",1,0") << line;
  EXPECT_TRUE(std::string(gameLogHeader).ends_with(",shots_left,shots_right"));
}

TEST(GameLog, aLine) {
  const std::string nothingElse = ",0,0,0,0,0,0,0,0,0,0,0,0,0,0";
  GameResult result;
  result.teamLeft = "Red,\"one\"";
  result.scoreLeft = 2;
  result.gameSeconds = 600.02;
  result.wallSeconds = 81.26;
  GameLogEntry entry{
      .date = "2015-07-01T10:00:00+0200", .server = "simulator", .seed = "7", .nameRight = "Blue"};
  EXPECT_EQ(gameLogLine(entry, result),
            std::string(
                "2015-07-01T10:00:00+0200,simulator,Red__one_,Blue,7,300,2,0,0,0,0,0,0,0,600.02,81.3,over") +
                nothingElse);
  result.end = GameEnd::serverGone;
  entry.halfTime = 12.5;
  EXPECT_EQ(gameLogLine(entry, result), std::string("2015-07-01T10:00:00+0200,simulator,Red__one_,Blue,7,12."
                                                    "5,2,0,0,0,0,0,0,0,600.02,81.3,server gone") +
                                            nothingElse);
}

TEST(GameLog, manyWritersOneHeader) {
  const std::string file = testing::TempDir() + "games-" + std::to_string(getpid()) + ".log";
  std::filesystem::remove(file);
  std::vector<std::thread> writers;
  for (int i = 0; i < 4; ++i)
    writers.emplace_back([&] {
      for (int k = 0; k < 25; ++k) appendGameLog(file, "line");
    });
  for (auto& writer : writers) writer.join();
  std::ifstream in(file);
  std::string line;
  std::getline(in, line);
  EXPECT_EQ(line, gameLogHeader);
  int lines = 0;
  while (std::getline(in, line)) {
    EXPECT_EQ(line, "line");
    ++lines;
  }
  EXPECT_EQ(lines, 100);
  std::filesystem::remove(file);
  try {
    appendGameLog("/nowhere/games.log", "line");
    FAIL();
  } catch (const std::runtime_error& error) {
    EXPECT_STREQ(error.what(), "cannot write /nowhere/games.log: No such file or directory");
  }
}

}  // namespace
}  // namespace plumbline::watch
