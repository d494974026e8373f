#include "modules/evaluation/DecisionRecorder.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <memory>
#include <optional>
#include <string>

#include "framework/ConfigurationError.h"
#include "modules/evaluation/OutputProblems.h"
#include "support/ModuleHarness.h"
#include "support/ScratchFolder.h"
#include "support/Thrown.h"

namespace plumbline {
namespace {

const std::string decisionColumns =
    "clock,x,y,action1,endX1,endY1,value1,goal1,action2,endX2,endY2,value2,goal2,"
    "action3,endX3,endY3,value3,goal3,action4,endX4,endY4,value4,goal4\n";

class DecisionRecorderTest : public testing::Test {
protected:
  DecisionRecorderTest() {
    harness->objects().set(std::make_shared<DecisionOptions>(DecisionOptions{folder / "all"}));
    harness->input<PlayerInfo>().number = 5;
    harness->input<PlayerInfo>().sideKnown = true;
    harness->input<FrameInfo>();
    decision().valid = true;
    decision().ball = {1, 2};
    decision().options = {option("kickLong", {9, 2}, 0.4), option("dribble", {2, 2}, 0.25)};
  }
  static StrikerOption option(const std::string& action, const Vec2& end, double value) {
    StrikerOption option;
    option.action = action;
    option.end = end;
    option.value = value;
    option.goal = 0.125;
    return option;
  }
  StrikerDecision& decision() { return harness->input<StrikerDecision>(); }
  void cycle(double time) {
    harness->input<FrameInfo>().time = time;
    harness->input<GameState>().time = time - 100;
    harness->cycle();
  }
  std::string written(const std::string& file = "left-5.csv") { return folder.read("all/" + file); }
  long lines() { return std::ranges::count(written(), '\n') - 1; }
  test::ScratchFolder folder;
  std::optional<test::ModuleHarness<DecisionRecorder>> harness{std::in_place};
};

TEST_F(DecisionRecorderTest, writesWhatWasChosenAndWhatNot) {
  cycle(110);
  EXPECT_EQ(written(), decisionColumns +
                           "10.00,1.00,2.00,kickLong,9.00,2.00,0.400,0.125,dribble,2.00,2.00,0.250,0.125,"
                           ",,,,,,,,,\n");
}

TEST_F(DecisionRecorderTest, anotherDecisionIsALineAndTheSameOneNowAndThen) {
  cycle(110);
  cycle(110.5);
  EXPECT_EQ(lines(), 1) << "the same";
  decision().options[0].end = {9, 2.3};
  cycle(110.6);
  EXPECT_EQ(lines(), 1) << "the same but for 2 degrees";
  decision().options[0].end = {9, 4};
  cycle(110.7);
  EXPECT_EQ(lines(), 2);
  decision().options[0].action = "dribble";
  cycle(110.8);
  EXPECT_EQ(lines(), 2) << "too soon after the last line";
  cycle(110.91);
  EXPECT_EQ(lines(), 3);
  for (int i = 0; i < 90; ++i) cycle(111 + 0.05 * i);
  EXPECT_EQ(lines(), 7) << "one each second";
}

TEST_F(DecisionRecorderTest, writesNothingUntilThePlayerIsKnownAndPlaysTheBall) {
  decision().valid = false;
  cycle(110);
  decision().valid = true;
  harness->input<PlayerInfo>().sideKnown = false;
  cycle(111);
  harness->input<PlayerInfo>().sideKnown = true;
  harness->input<GameState>().playMode = TeamPlayMode::beforeKickOff;
  cycle(111.5);
  harness->input<GameState>().playMode = TeamPlayMode::playOn;
  EXPECT_EQ(written(), "");
  harness->input<PlayerInfo>().sideKnown = true;
  harness->input<PlayerInfo>().leftSide = false;
  cycle(112);
  EXPECT_NE(written("right-5.csv"), "");
}

TEST_F(DecisionRecorderTest, aFileIsBounded) {
  harness->module().maxLines = 3;
  for (int i = 0; i < 50; ++i) cycle(110 + 2 * i);
  EXPECT_EQ(lines(), 3);
}

TEST_F(DecisionRecorderTest, aFileThatCannotBeWrittenIsSaidOnceAndThePlayerPlaysOn) {
  auto problems = std::make_shared<OutputProblems>([](const std::string&) {});
  harness->objects().set(problems);
  harness->module();
  folder.write("all/left-5.csv/in", "the way");
  for (int i = 0; i < 3; ++i) cycle(110 + 2 * i);
  EXPECT_TRUE(problems->any());
  EXPECT_FALSE(harness->stop().requested());
}

TEST_F(DecisionRecorderTest, aFolderThatCannotBeIsAnErrorAtTheStart) {
  harness->objects().set(std::make_shared<DecisionOptions>(DecisionOptions{"/proc/nope"}));
  EXPECT_THROW(harness->module(), ConfigurationError);
  EXPECT_EQ(thrownBy([&] { harness->module().init(); }),
            "--decisions: /proc/nope: cannot be written: No such file or directory; choose another folder");
}

TEST_F(DecisionRecorderTest, withoutAFolderItWritesNothing) {
  test::ModuleHarness<DecisionRecorder> none;
  none.input<StrikerDecision>() = decision();
  none.input<PlayerInfo>().sideKnown = true;
  none.input<PlayerInfo>().number = 1;
  none.input<FrameInfo>();
  none.input<GameState>();
  none.cycle();
  EXPECT_EQ(written("left-1.csv"), "");
}

}  // namespace
}  // namespace plumbline
