#include "modules/behavior/striker/ActionChoice.h"

#include <gtest/gtest.h>

#include "framework/ConfigFile.h"
#include "situation/kinds/StrikerSituationKind.h"
#include "support/Robots.h"
#include "support/SituationHarness.h"

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
    situation.kicks = {{.distance = 4, .scatter = 0.12, .spread = 0.01}};
    parameters.timePrice = 0;
    add(false, {14.5, 0});
  }
  void add(bool mate, const Vec2& place, bool fallen = false) {
    test::addRobot(situation.others, mate, place).fallen = fallen;
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
  // 4 m ahead the robot is there after 5 s, the keeper after 10.5 m: a whole advantage. The mean of a cosine
  // over its scatter of 0.12 rad is exp(-0.12^2 / 2).
  EXPECT_NEAR(judge(Kind::kick, 0).value, 0.05 * 4 * std::exp(-0.0072) + 0.2, 1e-3);
  EXPECT_NEAR(judge(Kind::kick, 0).end.x(), 4, 1e-12);
  EXPECT_EQ(judge(Kind::kick, 0).goal, 0);
}

TEST_F(ActionChoiceTest, secondsCost) {
  parameters.timePrice = 0.01;
  const double dear = judge(Kind::kick, 0).value;
  parameters.timePrice = 0;
  // A second to the ball at 0.8 m/s and a quarter, the kick, and 5 s after the ball.
  EXPECT_NEAR(judge(Kind::kick, 0).value - dear, 0.01 * (1 / 0.8 + parameters.kickSeconds + 5), 1e-9);
}

TEST_F(ActionChoiceTest, aKickThatComesTooLateIsALostBall) {
  add(false, {0.2, 0.3});
  EXPECT_NEAR(judge(Kind::kick, 0).value, -0.2, 0.05);
  EXPECT_GT(judge(Kind::dribble, 0).value, judge(Kind::kick, 0).value);
}

TEST_F(ActionChoiceTest, opponentsThatAreKeptOffLeaveTimeToKick) {
  add(false, {-0.2, 1.1});
  const double pressed = judge(Kind::kick, 0).value;
  situation.freeSeconds = 6;
  EXPECT_GT(judge(Kind::kick, 0).value, pressed + 0.1);
}

TEST_F(ActionChoiceTest, aShotNowIsWorthMoreThanASurerOneLater) {
  situation.ball = {11, 0};
  situation.robot = Pose2(10.7, 0, 0);
  situation.kicks[0].distance = 8;
  situation.others.clear();
  add(false, {14.5, 1.5});
  parameters.goalWorth = 1;
  const StrikerAction shot = judgeAction(Kind::kick, 0, 8, situation, value, time, parameters);
  ASSERT_GT(shot.goal, 0.2);
  parameters.goalWorth = 1.5;
  const StrikerAction dearer = judgeAction(Kind::kick, 0, 8, situation, value, time, parameters);
  EXPECT_EQ(dearer.goal, shot.goal);
  // Half a goal more for each, as far as the robot is first at the ball.
  EXPECT_GT(dearer.value, shot.value + 0.25 * shot.goal);
  EXPECT_LT(dearer.value, shot.value + 0.51 * shot.goal);
}

TEST_F(ActionChoiceTest, fastOpponentsAreThereSooner) {
  add(false, {4, 0});
  const double before = judge(Kind::kick, 0).value;
  situation.opponentSpeed = 1.6;
  EXPECT_LT(judge(Kind::kick, 0).value, before - 0.05);
}

TEST_F(ActionChoiceTest, theBallRollsAsFarAsTheFirstInItsWay) {
  add(false, {2, 0.2});
  EXPECT_NEAR(judge(Kind::kick, 0).end.x(), 2, 1e-12);
  situation.others.back().fallen = true;
  EXPECT_NEAR(judge(Kind::kick, 0).end.x(), 2, 1e-12) << "not over who lies";
  situation.kicks[0].rise = 0.3;
  EXPECT_NEAR(judge(Kind::kick, 0).end.x(), 4, 1e-12);
}

TEST_F(ActionChoiceTest, withAnOpponentAtTheBallItIsPushedAtOnce) {
  situation.robot = Pose2(-0.2, 0, 0);
  add(false, {0.5, 0.3});
  EXPECT_EQ(choose().kind, Kind::dribble);
  situation.others.back().position = {0.5, 3};
  EXPECT_EQ(choose().kind, Kind::kick);
}

TEST_F(ActionChoiceTest, anOpponentNearTheWayStepsIntoIt) {
  // 3.9 m ahead the ball comes after more than a second, in which the opponent comes 0.25 m/s nearer.
  add(false, {3.9, 0.5});
  EXPECT_NEAR(judge(Kind::kick, 0).end.x(), 3.9, 1e-12);
  parameters.blockSpeed = 0;
  EXPECT_NEAR(judge(Kind::kick, 0).end.x(), 4, 1e-12);
}

TEST_F(ActionChoiceTest, aBallOffTheFieldIsTheirs) {
  situation.ball = {0, 9};
  situation.robot = Pose2(0, 8, pi / 2);
  parameters.widest = 2.5;
  const StrikerAction out = judge(Kind::kick, pi / 2);
  EXPECT_NEAR(out.end.y(), 10, 1e-12);
  EXPECT_NEAR(out.value, -0.2, 5e-3);
}

struct ShotTest : ActionChoiceTest {
  ShotTest() {
    situation.ball = {13, 0};
    situation.robot = Pose2(12.5, 0, 0);
    situation.others.clear();
    add(false, {0, 0});
  }
};

TEST_F(ShotTest, isWorthItsChance) {
  // The ball's middle passes the posts at +- atan(1.008 / 2) = 0.467 rad, four deviations: all but certain.
  EXPECT_GT(judge(Kind::kick, 0).value, 0.99);
  situation.kicks[0].scatter = 0.467;  // one deviation: 68 %; of the rest what is over 2.5 is left out
  EXPECT_NEAR(judge(Kind::kick, 0).goal, 0.6827 / 0.9876, 1e-2);
}

TEST_F(ShotTest, mayFallShortOfTheLine) {
  situation.kicks[0] = {.distance = 2, .scatter = 0.01, .spread = 0.5};
  StrikerAction shot = judgeAction(Kind::kick, 0, 2, situation, value, time, parameters);
  EXPECT_NEAR(shot.goal, 0.5, 1e-3) << "half of them roll so far";
  situation.kicks[0].distance = 2.5;
  shot = judgeAction(Kind::kick, 0, 2.5, situation, value, time, parameters);
  EXPECT_NEAR(shot.goal, 0.8413, 1e-3) << "one deviation";
}

TEST_F(ShotTest, mayGoOverTheBar) {
  // Two metres are 0.833 of a flight of 0.6 x 4 m: there it is 0.556 of its height.
  situation.kicks[0].scatter = 0.01;
  situation.kicks[0].rise = (0.8 - 0.084) / 0.5556;
  EXPECT_NEAR(judge(Kind::kick, 0).goal, 0.5, 1e-2);
  situation.kicks[0].rise *= 3;
  EXPECT_LT(judge(Kind::kick, 0).goal, 0.05);
  situation.ball.x() = 12.4;  // it has come down before the line
  EXPECT_GT(judge(Kind::kick, 0).goal, 0.99);
}

TEST_F(ShotTest, aimsPastTheGoalie) {
  situation.kicks[0].scatter = 0.05;
  add(false, {14.5, -0.3});
  parameters.dribbleSpeed = 0.05;
  const StrikerAction shot = choose();
  EXPECT_EQ(shot.kind, Kind::kick);
  EXPECT_GT(shot.direction, 0.1);
  EXPECT_GT(shot.goal, 0.8);
}

TEST_F(ShotTest, itsToleranceIsThatOfTheGoal) {
  situation.kicks[0].scatter = 0.05;
  // 0.467 rad to either post, less some deviations.
  EXPECT_GT(judge(Kind::kick, 0).tolerance, 0.25);
  EXPECT_LT(judge(Kind::kick, 0).tolerance, 0.467);
  situation.ball.x() = 11.1;  // 0.25 rad to a post
  EXPECT_LT(judge(Kind::kick, 0).tolerance, 0.2);
}

TEST_F(ActionChoiceTest, takesTheKickThatGoesAsFarAsItShall) {
  add(true, {4, 0});
  add(false, {9, 0});  // a longer kick is theirs
  situation.kicks = {{.distance = 4, .spread = 0.6}, {.distance = 9, .spread = 0.6}};
  EXPECT_EQ(choose().reach, 4);
  situation.others.pop_back();
  EXPECT_EQ(choose().reach, 9);
}

TEST_F(ActionChoiceTest, tellsTheBestOfEachWayToPlayTheBall) {
  situation.kicks.push_back({.distance = 7, .scatter = 0.12, .spread = 0.01});
  std::vector<StrikerAction> compared(9);
  const StrikerAction chosen = chooseAction(situation, {}, value, time, parameters, &compared);
  ASSERT_EQ(compared.size(), 3u) << "two kicks and dribbling";
  EXPECT_EQ(compared[0].reach, 4);
  EXPECT_EQ(compared[1].reach, 7);
  EXPECT_EQ(compared[2].kind, Kind::dribble);
  double best = -1;
  for (const StrikerAction& one : compared) best = std::max(best, one.value);
  EXPECT_EQ(chosen.value, best);
  EXPECT_EQ(chosen.direction, choose().direction) << "the same as without";
}

TEST_F(ActionChoiceTest, staysWithItsChoiceWhileNoOtherIsClearlyBetter) {
  const StrikerAction best = choose();
  EXPECT_NEAR(best.direction, 0, 0.06);
  StrikerAction last = best;
  last.direction = 0.18;
  EXPECT_NEAR(choose(last).direction, 0.18, 0.03);
  last.direction = 1.5;
  EXPECT_EQ(choose(last).direction, best.direction);
}

TEST_F(ActionChoiceTest, aloneWhatCountsIsWhenTheGoalFalls) {
  situation.others.clear();
  situation.ball = {5, 0};
  situation.robot = Pose2(4.5, 0, 0);
  situation.kicks = {{.distance = 4, .scatter = 0.1, .spread = 0.5},
                     {.distance = 9, .scatter = 0.3, .spread = 1}};
  // The long kick ends aside of the goal as often as before it.
  EXPECT_EQ(choose().reach, 4);
  situation.kicks[1].scatter = 0.03;
  situation.ball = {7, 0};
  situation.robot = Pose2(6.5, 0, 0);
  EXPECT_EQ(choose().reach, 9);
}

TEST_F(ActionChoiceTest, theFallenDoNotPress) {
  add(false, {0.5, 0}, true);
  OtherRobots all;
  all.robots = situation.others;
  EXPECT_GT(all.nearestOpponent(situation.ball), 14);
}

/// A file with positions and the decision that people expect (tests/data/situations/striker).
class SituationTest : public testing::TestWithParam<std::string> {};

TEST_P(SituationTest, isDecidedAsExpected) {
  const test::WrittenSituation<StrikerExpected> written("striker", GetParam());
  StrikerSituation situation;
  situation.robot = written->robot;
  situation.ball = written->ball;
  situation.others = written->others;
  situation.places.players = written->going;
  situation.kicks = knownTo<StrikerKnowledge>(*written).kicks;
  const StrikerExpected& expected = written.expected();
  const Vec2 reach = expected.reach.value_or(Vec2(0, 100));

  const ConfigFile table("config/field_value.yaml");
  const StrikerAction chosen =
      chooseAction(situation, {}, FieldValue(table.root()), TimeToBallParameters(), ActionChoiceParameters());
  if (expected.action != StrikerExpected::Action::any) {
    EXPECT_EQ(chosen.kind, expected.action == StrikerExpected::Action::kick ? Kind::kick : Kind::dribble);
  }
  EXPECT_GE(chosen.reach, reach[0]) << "value " << chosen.value;
  EXPECT_LE(chosen.reach, reach[1]) << "value " << chosen.value;
  EXPECT_GE(chosen.direction, expected.direction[0]) << "value " << chosen.value;
  EXPECT_LE(chosen.direction, expected.direction[1]) << "value " << chosen.value;
}

INSTANTIATE_TEST_SUITE_P(Written, SituationTest, testing::ValuesIn(test::situationNames("striker")),
                         test::situationName);

}  // namespace
