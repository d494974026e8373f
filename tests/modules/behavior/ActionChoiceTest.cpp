#include "modules/behavior/striker/ActionChoice.h"

#include <gtest/gtest.h>

#include "framework/ConfigFile.h"

using namespace plumbline;

namespace {

using Kind = StrikerAction::Kind;

/// A value that rises by 0.05 per metre and by 0.2 with the ball.
FieldValue slope() {
  FieldGrid grid({-16, 16}, {0, 10});
  std::vector<double> values(grid.size());
  for (std::size_t i = 0; i < values.size(); ++i)
    values[i] = 0.05 * grid.state(i).place.x() + 0.2 * grid.state(i).advantage;
  return FieldValue(grid, values);
}

struct ActionChoiceTest : testing::Test {
  ActionChoiceTest() {
    situation.robot = Pose2(-1, 0, 0);
    situation.kicks = {4};
    add(false, {14.5, 0});
  }
  void add(bool mate, const Vec2& place, bool fallen = false) {
    OtherRobot& robot = situation.others.emplace_back();
    robot.mate = mate;
    robot.position = place;
    robot.fallen = fallen;
  }
  StrikerAction judge(Kind kind, double direction) const {
    return judgeAction(kind, direction, kind == Kind::kick ? 4 : parameters.dribbleWay, situation, value,
                       time, parameters);
  }
  StrikerAction choose(const StrikerAction& last = {}) const {
    return chooseAction(situation, last, value, time, parameters);
  }
  FieldValue value = slope();
  StrikerSituation situation;
  TimeToBallParameters time;
  ActionChoiceParameters parameters;
};

TEST_F(ActionChoiceTest, aFreeKickIsWorthWhereTheBallRests) {
  // 4 m ahead the robot is there after 5 s, the keeper after 10.5 m: a whole advantage.
  // It scatters by 0.12 rad: two of three kicks straight, the others sqrt(3) deviations aside.
  EXPECT_NEAR(judge(Kind::kick, 0).value, 0.05 * 4 * (2 + std::cos(std::sqrt(3.0) * 0.12)) / 3 + 0.2, 1e-6);
  EXPECT_NEAR(judge(Kind::kick, 0).end.x(), 4, 1e-12);
}

TEST_F(ActionChoiceTest, aKickThatComesTooLateIsALostBall) {
  add(false, {0.2, 0.3});
  EXPECT_NEAR(judge(Kind::kick, 0).value, -0.2, 0.05);
  EXPECT_GT(judge(Kind::dribble, 0).value, judge(Kind::kick, 0).value);
}

TEST_F(ActionChoiceTest, theBallRollsAsFarAsTheFirstInItsWay) {
  add(false, {2, 0.2});
  EXPECT_NEAR(judge(Kind::kick, 0).end.x(), 2, 1e-12);
  situation.others.back().fallen = true;
  EXPECT_NEAR(judge(Kind::kick, 0).end.x(), 4, 1e-12);
}

TEST_F(ActionChoiceTest, aBallOffTheFieldIsTheirs) {
  situation.ball = {0, 9};
  situation.robot = Pose2(0, 8, pi / 2);
  const StrikerAction out = judge(Kind::kick, pi / 2);
  EXPECT_NEAR(out.end.y(), 10, 1e-12);
  EXPECT_NEAR(out.value, -0.2, 1e-3);
}

TEST_F(ActionChoiceTest, aShotIsWorthItsChance) {
  situation.ball = {13, 0};
  situation.robot = Pose2(12.5, 0, 0);
  situation.others.clear();
  add(false, {0, 0});
  // Posts at +- atan(1.05 / 2) = 0.483 rad, four deviations: all but certain.
  EXPECT_GT(judge(Kind::kick, 0).value, 0.99);
  parameters.kickScatter = 0.483;  // one deviation: 68 %, the rest goes out at the line
  EXPECT_NEAR(judge(Kind::kick, 0).value, 0.6827 + 0.3173 * (0.05 * 15 - 0.2), 2e-3);
}

TEST_F(ActionChoiceTest, takesTheKickThatGoesAsFarAsItShall) {
  add(true, {4, 0});
  add(false, {9, 0});  // a longer kick is theirs
  situation.kicks = {4, 9};
  EXPECT_EQ(choose().reach, 4);
  situation.others.pop_back();
  EXPECT_EQ(choose().reach, 9);
}

TEST_F(ActionChoiceTest, staysWithItsChoiceWhileNoOtherIsClearlyBetter) {
  const StrikerAction best = choose();
  EXPECT_NEAR(best.direction, 0, 1e-9);
  StrikerAction last = best;
  last.direction = 0.15;
  EXPECT_EQ(choose(last).direction, 0.15);
  last.direction = 1.5;
  EXPECT_EQ(choose(last).direction, best.direction);
}

TEST_F(ActionChoiceTest, theFallenDoNotPress) {
  add(false, {0.5, 0}, true);
  OtherRobots all;
  all.robots = situation.others;
  EXPECT_GT(all.nearestOpponent(situation.ball), 14);
}

/// A file with positions and the decision that people expect (tests/data/situations).
class SituationTest : public testing::TestWithParam<const char*> {};

TEST_P(SituationTest, isDecidedAsExpected) {
  const ConfigFile file(std::string("tests/data/situations/") + GetParam() + ".yaml");
  const ConfigSection& root = file.root();
  StrikerSituation situation;
  const Vec3 robot = root.get<Vec3>("robot");
  situation.robot = Pose2(robot.x(), robot.y(), robot.z());
  situation.ball = root.get<Vec2>("ball");
  for (const bool mate : {true, false})
    for (const auto& place : root.get<std::vector<std::array<double, 2>>>(mate ? "mates" : "opponents")) {
      OtherRobot& other = situation.others.emplace_back();
      other.mate = mate;
      other.position = {place[0], place[1]};
    }
  situation.kicks = {3.4};
  const ConfigSection expected = root.section("expected");
  const std::size_t action = expected.choice("action", {"any", "kick", "dribble"});
  const Vec2 direction = expected.get<Vec2>("direction", {-pi, pi});

  const ConfigFile table("config/field_value.yaml");
  const StrikerAction chosen =
      chooseAction(situation, {}, FieldValue(table.root()), TimeToBallParameters(), ActionChoiceParameters());
  if (action != 0) {
    EXPECT_EQ(chosen.kind, action == 1 ? Kind::kick : Kind::dribble);
  }
  EXPECT_GE(chosen.direction, direction[0]) << "value " << chosen.value;
  EXPECT_LE(chosen.direction, direction[1]) << "value " << chosen.value;
}

INSTANTIATE_TEST_SUITE_P(Written, SituationTest,
                         testing::Values("beforeTheEmptyGoal", "freeInMidfield", "keeperInTheMiddle",
                                         "nearTheSideLine", "onTheOwnGoalLine", "opponentAtTheBall",
                                         "wrongSideUnderPressure"),
                         [](const auto& name) { return std::string(name.param); });

}  // namespace
