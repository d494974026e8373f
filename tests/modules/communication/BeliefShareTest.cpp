#include "modules/communication/BeliefShare.h"

#include <gtest/gtest.h>

#include "support/DrawnBy.h"
#include "support/ModuleHarness.h"

using namespace plumbline;

namespace {

struct BeliefShareTest : testing::Test {
  BeliefShareTest() {
    harness.input<FrameInfo>().time = 20;
    harness.input<PlayerInfo>().number = 3;
    harness.input<RobotPose>().valid = true;
    harness.input<RobotPose>().pose = Pose2(-2, 1, pi / 2);
    harness.input<LocalBallPos>().valid = true;
    harness.input<LocalBallPos>().lastSeen = 19.9;
    harness.input<LocalBallPos>().position = {1, 0};
    harness.input<LocalBallPos>().velocity = {0.5, 0};
    harness.input<LocalOtherRobots>();
    harness.input<SayMessage>();
    harness.input<PlayerRole>().role = PlayerRole::striker;
  }
  static TeamBelief beliefOf(int number, const Vec2& ball, double ballAge = 0.1) {
    TeamBelief belief;
    belief.number = number;
    belief.localised = true;
    belief.ballKnown = true;
    belief.ball = ball;
    belief.ballAge = ballAge;
    return belief;
  }
  void hear(const std::vector<TeamBelief>& beliefs) {
    harness.input<TeamComDataIn>().beliefs = beliefs;
    harness.cycle();
    harness.input<TeamComDataIn>().beliefs.clear();
  }
  void pass(double seconds) {
    harness.input<FrameInfo>().time += seconds;
    harness.cycle();
  }
  test::ModuleHarness<BeliefShare> harness;
};

TEST_F(BeliefShareTest, tellsWhatThisPlayerSees) {
  harness.cycle();
  const TeamBelief& belief = harness.output<TeamComDataOut>().belief;
  EXPECT_EQ(belief.number, 3);
  EXPECT_EQ(belief.role, PlayerRole::striker);
  EXPECT_TRUE(belief.ballKnown);
  EXPECT_LT((belief.ball - Vec2(-2, 2)).norm(), 1e-9);
  EXPECT_LT((belief.ballVelocity - Vec2(0, 0.5)).norm(), 1e-9);
  EXPECT_NEAR(belief.ballAge, 0.1, 1e-9);
}

TEST_F(BeliefShareTest, whoDoesNotKnowWhereItIsTellsOfNoBall) {
  harness.input<RobotPose>().valid = false;
  harness.cycle();
  EXPECT_FALSE(harness.output<TeamComDataOut>().belief.ballKnown);
}

TEST_F(BeliefShareTest, tellsTwoOpponentsAtATimeAndInTimeAllOfThem) {
  for (const int number : {2, 5, 9}) {
    OtherRobot& robot = harness.input<LocalOtherRobots>().robots.emplace_back();
    robot.number = number;
    robot.lastSeen = 19.9;
  }
  const auto sent = [&] {
    harness.cycle();
    const TeamBelief& belief = harness.output<TeamComDataOut>().belief;
    SayMessage& said = harness.input<SayMessage>();
    said.said = belief;
    said.time = harness.input<FrameInfo>().time;
    std::vector<int> numbers;
    for (const SaidOpponent& opponent : belief.opponents) numbers.push_back(opponent.number);
    harness.input<FrameInfo>().time += 0.02;
    return numbers;
  };
  EXPECT_EQ(sent(), (std::vector<int>{2, 5}));
  EXPECT_EQ(sent(), (std::vector<int>{9, 2}));
  EXPECT_EQ(sent(), (std::vector<int>{5, 9}));
}

TEST_F(BeliefShareTest, combinesTheBallsOfMatesAndForgetsThem) {
  hear({beliefOf(5, {1, 1}), beliefOf(8, {1.1, 1})});
  const TeamBallPos& ball = harness.output<TeamBallPos>();
  ASSERT_TRUE(ball.valid);
  EXPECT_NEAR(ball.field.x(), 1.05, 0.02);
  EXPECT_NEAR(ball.age, 0.1, 1e-9);
  const double before = ball.deviation;
  pass(2);
  EXPECT_TRUE(ball.valid);
  EXPECT_GT(ball.deviation, before);
  pass(2.1);
  EXPECT_FALSE(ball.valid);
}

TEST_F(BeliefShareTest, mateAndOpponentsByTheirWords) {
  TeamBelief belief = beliefOf(5, {1, 1});
  belief.pose = Pose2(4, 3, 0);
  belief.fallen = true;
  belief.opponents.emplace_back().number = 10;
  belief.opponents.back().position = {7, 0};
  hear({belief});
  const auto& robots = harness.output<TeamOtherRobots>().robots;
  ASSERT_EQ(robots.size(), 2u);
  EXPECT_TRUE(robots[0].mate && robots[0].fallen);
  EXPECT_EQ(robots[0].position, Vec2(4, 3));
  EXPECT_FALSE(robots[1].mate);
  EXPECT_EQ(robots[1].number, 10);
  EXPECT_EQ(harness.output<TeamRobotPose>().reports.size(), 1u);
  ASSERT_TRUE(harness.output<TeamRobotPose>().of(5));
  pass(5);
  EXPECT_TRUE(harness.output<TeamOtherRobots>().robots.empty());
  EXPECT_FALSE(harness.output<TeamRobotPose>().of(5));
}

TEST_F(BeliefShareTest, ownWordsCountAsMatesHeardThem) {
  SayMessage& said = harness.input<SayMessage>();
  said.said = beliefOf(3, {9, 9});
  said.said.timeToBall = 4;
  said.time = 20;
  harness.cycle();
  ASSERT_TRUE(harness.output<TeamRobotPose>().of(3));
  EXPECT_EQ(harness.output<TeamRobotPose>().of(3)->belief.timeToBall, 4);
  EXPECT_FALSE(harness.output<TeamBallPos>().valid);  // the own ball is no news
}

TEST_F(BeliefShareTest, whatMatesSaidIsDrawn) {
  const Drawing drawing = test::drawnBy("draw:belief:heard", [&] { hear({beliefOf(5, {1, 1})}); });
  EXPECT_EQ(test::placeOf(drawing, "mate 5"), Vec3(0, 0, 0)) << "where it says that it is";
  EXPECT_EQ(test::countOf<shapes::Circle>(drawing), 1u);
}

}  // namespace
