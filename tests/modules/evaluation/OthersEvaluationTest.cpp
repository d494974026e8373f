#include "modules/evaluation/OthersEvaluation.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <vector>

#include "modules/evaluation/OutputProblems.h"
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
  std::vector<std::string> configured() const {
    folder.write("OthersEvaluation.yaml", "folder: " + folder / "others" + "\n");
    return {folder.path()};
  }
  test::ScratchFolder folder;
  test::ModuleHarness<OthersEvaluation> harness{configured()};
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
  EXPECT_EQ(written(), "");
  player.leftSide = false;
  pose.valid = true;
  clockAt(3);
  EXPECT_EQ(written("right-5.csv"), columns);
}

TEST_F(OthersEvaluationTest, aFileThatCannotBeWrittenIsSaidOnce) {
  clockAt(0);
  folder.write("others/left-5.csv/in", "the way");
  testing::internal::CaptureStderr();
  for (int i = 0; i < 4; ++i) clockAt(1 + i);
  EXPECT_EQ(testing::internal::GetCapturedStderr(),
            "the estimates end here: " + folder / "others/left-5.csv" +
                ": cannot be written: Is a directory; make room, or choose another folder\n");
  EXPECT_TRUE(harness.objects().find<OutputProblems>()->any());
}

TEST_F(OthersEvaluationTest, aFolderThatCannotBeIsAnErrorAtTheStart) {
  folder.write("OthersEvaluation.yaml", "folder: " + folder / "file/in" + "\n");
  folder.write("file", "");
  test::ModuleHarness<OthersEvaluation> bad({folder.path()});
  EXPECT_EQ(thrownBy([&] { bad.module(); }),
            folder / "OthersEvaluation.yaml" + ":1: folder " + folder / "file/in" +
                ": cannot be written: Not a directory; choose another folder");
}

}  // namespace
}  // namespace plumbline
