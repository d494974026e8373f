#include "modules/evaluation/OthersEvaluation.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>

#include "support/ModuleHarness.h"
#include "support/Robots.h"
#include "support/ScratchFolder.h"
#include "support/Thrown.h"

namespace plumbline {
namespace {

constexpr const char* columns = "time,belief,what,number,x,y,deviation,distance,age\n";

class OthersEvaluationTest : public testing::Test {
protected:
  OthersEvaluationTest() {
    harness.module().folder = folder / "others";
    player.number = 5;
    pose.valid = true;
    pose.pose = Pose2(1, 0, 0);
    harness.input<FrameInfo>().time = 100;
  }
  void clockAt(double time) {
    game.time = time;
    harness.cycle();
  }
  std::string written(const std::string& name = "left-5.csv") const { return folder.read("others/" + name); }
  test::ScratchFolder folder;
  test::ModuleHarness<OthersEvaluation> harness;
  GameState& game = harness.input<GameState>();
  PlayerInfo& player = harness.input<PlayerInfo>();
  RobotPose& pose = harness.input<RobotPose>();
};

TEST_F(OthersEvaluationTest, writesALineOfEachEstimate) {
  LocalBallPos& own = harness.input<LocalBallPos>();
  own.valid = true;
  own.position = {2, 0};
  own.deviation = 0.125;
  own.lastSeen = 99.5;
  BallPos& ball = harness.input<BallPos>();
  ball.valid = true;
  ball.field = {1, 4};
  ball.age = 0.25;
  test::addRobot(harness.input<LocalOtherRobots>().robots, false, {1, -1}, 3).lastSeen = 98;
  test::addRobot(harness.input<OtherRobots>().robots, true, {4, 4}, 9).lastSeen = 100;
  clockAt(7);
  EXPECT_EQ(written(), std::string(columns) +
                           "7.00,alone,ball,0,3.000,0.000,0.125,2.00,0.50\n"
                           "7.00,team,ball,0,1.000,4.000,0.000,4.00,0.25\n"
                           "7.00,alone,opponent,3,1.000,-1.000,1.000,1.00,2.00\n"
                           "7.00,team,mate,9,4.000,4.000,1.000,5.00,0.00\n");
}

TEST_F(OthersEvaluationTest, aLineForEachIntervalWhileTheClockRuns) {
  harness.input<BallPos>().valid = true;
  for (int i = 1; i <= 60; ++i) clockAt(0.02 * i);
  for (int i = 0; i < 60; ++i) clockAt(1.2);  // it stands
  const std::string text = written();
  EXPECT_EQ(std::count(text.begin(), text.end(), '\n'), 4);
  EXPECT_NE(text.find("\n0.02,"), std::string::npos);
  EXPECT_NE(text.find("\n0.50,"), std::string::npos);
  EXPECT_NE(text.find("\n1.00,"), std::string::npos);
}

TEST_F(OthersEvaluationTest, withoutANumberOrAPlaceNothingIsWritten) {
  player.number = 0;
  clockAt(1);
  player.number = 5;
  pose.valid = false;
  clockAt(2);
  EXPECT_FALSE(std::filesystem::exists(folder / "others"));
  player.leftSide = false;
  pose.valid = true;
  clockAt(3);
  EXPECT_EQ(written("right-5.csv"), columns);
}

TEST_F(OthersEvaluationTest, aFolderThatCannotBeIsAnError) {
  folder.write("others/left-5.csv/in", "the way");
  EXPECT_EQ(thrownBy([&] { clockAt(1); }), "cannot write " + folder / "others/left-5.csv");
}

}  // namespace
}  // namespace plumbline
