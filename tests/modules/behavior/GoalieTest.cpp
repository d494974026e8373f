#include "modules/behavior/Goalie.h"

#include <gtest/gtest.h>

#include "situation/kinds/GoalieSituationKind.h"
#include "support/ModuleHarness.h"
#include "support/SituationHarness.h"

using namespace plumbline;

namespace {

struct GoalieTest : testing::Test {
  GoalieTest() {
    harness.input<FrameInfo>().cycleSeconds = 0.02;
    harness.input<GameState>().playMode = TeamPlayMode::playOn;
    harness.input<FieldDimensions>();
    harness.input<RobotPose>().valid = true;
    harness.input<RobotPose>().pose = Pose2(-10, 8, 0);
    harness.input<PlayerRole>().role = PlayerRole::goalie;
    harness.input<PlayerRole>().keeper = true;
    harness.input<BallPos>().valid = true;
    harness.input<BallPos>().age = 0;
  }
  const BehaviorOutput& with(const Vec2& ball, const Vec2& velocity = Vec2::Zero()) {
    const Pose2& pose = harness.input<RobotPose>().pose;
    harness.input<BallPos>().field = ball;
    harness.input<BallPos>().relative = pose.inverse() * ball;
    harness.input<BallPos>().relativeVelocity = pose.rotation().transpose() * velocity;
    harness.cycle();
    return harness.output<GoalieOutput>();
  }
  test::ModuleHarness<Goalie> harness;
};

TEST_F(GoalieTest, halvesTheAngleOfTheGoalFromEveryBall) {
  for (const Vec2& ball : {Vec2(0, 0), Vec2(-10, 4), Vec2(-12, -3), Vec2(5, 9)}) {
    const Vec2 place = with(ball).target.position;
    const auto angleTo = [&](const Vec2& p) { return std::atan2(p.y() - ball.y(), p.x() - ball.x()); };
    const double toLeft = normalizeAngle(angleTo({-15, 1.05}) - angleTo(place));
    const double toRight = normalizeAngle(angleTo(place) - angleTo({-15, -1.05}));
    EXPECT_NEAR(toLeft, toRight, 1e-6) << ball.transpose();
    EXPECT_GT(place.x(), -15);
  }
}

TEST_F(GoalieTest, standsFartherOutTheFartherTheBall) {
  EXPECT_GT(with({5, 0}).target.x(), with({-12, 0}).target.x());
  EXPECT_NEAR(with({-12, 0}).target.x(), -14.5, 1e-9);
}

TEST_F(GoalieTest, neverStandsBehindTheLineOrOutsideTheGoal) {
  for (double x = -15.2; x < 15; x += 0.4)
    for (double y = -10; y < 10; y += 0.5) {
      const Vec2 place = with({x, y}).target.position;
      EXPECT_GE(place.x(), -14.75 - 1e-9);
      EXPECT_LE(std::abs(place.y()), 1.05 + 1e-9);
    }
}

/// Shots from 4 m ahead of a keeper who stands on the line and looks at the middle of the field.
struct KeeperShotTest : GoalieTest {
  KeeperShotTest() { harness.input<RobotPose>().pose = Pose2(-14.5, 0, 0); }
  const BehaviorOutput& shot(double aside, double speed) { return surely({-10.5, aside}, {-speed, 0}); }
  /// Seen for long enough.
  const BehaviorOutput& surely(const Vec2& ball, const Vec2& velocity) {
    for (int i = 0; i < 5; ++i) with(ball, velocity);
    return with(ball, velocity);
  }
};

TEST_F(KeeperShotTest, divesForAShotThatItCannotStepTo) {
  EXPECT_EQ(shot(0.5, 8).skill, Skill::dive);
  EXPECT_NEAR(shot(0.5, 8).target.x(), -14.5, 1e-9);
  EXPECT_NEAR(shot(0.5, 8).target.y(), 0.5, 1e-9);
  EXPECT_EQ(shot(-0.5, 8).skill, Skill::dive);
  EXPECT_NEAR(surely({-10.5, 0.5}, {-8, -2}).target.y(), -0.5, 1e-9) << "where it passes";
}

TEST_F(KeeperShotTest, divesOnceItIsSureOfTheSide) {
  for (int i = 0; i < 5; ++i) EXPECT_NE(with({-10.5, 0.5}, {-8, 0}).skill, Skill::dive) << i;
  for (int i = 0; i < 5; ++i) EXPECT_NE(with({-10.5, -0.5}, {-8, 0}).skill, Skill::dive) << i;
  EXPECT_EQ(with({-10.5, -0.5}, {-8, 0}).skill, Skill::dive);
}

TEST_F(KeeperShotTest, alsoDivesWhileItIsTheStriker) {
  harness.input<PlayerRole>().role = PlayerRole::striker;
  EXPECT_EQ(shot(0.5, 8).skill, Skill::dive);
  EXPECT_TRUE(shot(0.5, 8).active);
  EXPECT_FALSE(shot(0.05, 8).active);
  harness.input<PlayerRole>().keeper = false;
  EXPECT_FALSE(shot(0.5, 8).active) << "no keeper";
}

TEST_F(KeeperShotTest, staysOnItsFeetForOtherShots) {
  EXPECT_NE(shot(0.05, 8).skill, Skill::dive) << "at its feet";
  EXPECT_NE(shot(1.02, 8).skill, Skill::dive) << "out of reach";
  EXPECT_NE(shot(0.15, 5).skill, Skill::dive) << "1.9 s: there is time for a step";
  EXPECT_NE(shot(0.5, 4.2).skill, Skill::dive) << "not yet";
  EXPECT_NE(shot(0.5, 3).skill, Skill::dive) << "does not come so far";
  EXPECT_NE(shot(0.5, -8).skill, Skill::dive) << "goes away";
  EXPECT_NE(surely({-10.5, 0.5}, {-8, -6}).skill, Skill::dive) << "beside the goal";
  harness.module().dives = false;
  EXPECT_NE(shot(0.5, 8).skill, Skill::dive);
}

TEST_F(GoalieTest, stepsIntoTheWayOfAShot) {
  const Vec2 place = with({-10, 0}, {-7, 1}).target.position;
  EXPECT_NEAR(place.y(), -(place.x() + 10) / 7, 1e-6);
  EXPECT_NEAR(with({-10, 0}, {-7, 5}).target.y(), 0, 1e-6);    // passes the goal
  EXPECT_NEAR(with({-10, 0}, {-2, 0.4}).target.y(), 0, 1e-6);  // comes to rest before
}

TEST_F(GoalieTest, standsStillAtItsPlace) {
  const Pose2 place = with({0, 0}).target;
  harness.input<RobotPose>().pose = place;
  EXPECT_EQ(with({0, 0}).skill, Skill::stand);
  harness.input<RobotPose>().pose = Pose2(place.x(), 0.25, 0);
  EXPECT_EQ(with({0, 0}).skill, Skill::stand);
  harness.input<RobotPose>().pose = Pose2(place.x(), 0.4, 0);
  EXPECT_EQ(with({0, 0}).skill, Skill::moveToPos);
}

// A keeper stands within 0.15 m of its place and stays there up to 0.3 m, but not one that comes from the
// ball.
TEST_F(GoalieTest, aKeeperThatWasTheStrikerWalksToItsPlaceAgain) {
  const Pose2 place = with({0, 0}).target;
  harness.input<PlayerRole>().role = PlayerRole::striker;
  harness.input<RobotPose>().pose = Pose2(place.x(), 0.25, 0);
  EXPECT_FALSE(with({0, 0}).active);
  harness.input<PlayerRole>().role = PlayerRole::goalie;
  EXPECT_EQ(with({0, 0}).skill, Skill::moveToPos);
  harness.input<RobotPose>().pose = place;
  EXPECT_EQ(with({0, 0}).skill, Skill::stand);
}

TEST_F(GoalieTest, onlyTheGoalieIsOne) {
  harness.input<PlayerRole>().role = PlayerRole::striker;
  EXPECT_FALSE(with({0, 0}).active);
}

TEST_F(GoalieTest, waitsInTheGoalWhileNobodyKnowsTheBall) {
  harness.input<BallPos>().valid = false;
  EXPECT_NEAR(with({5, 5}).target.x(), -14.5, 1e-9);
  EXPECT_NEAR(with({5, 5}).target.y(), 0, 1e-9);
}

/// A file with positions and where people expect the keeper to go (tests/data/situations/goalie).
struct GoalieSituations : GoalieTest, testing::WithParamInterface<std::string> {};

TEST_P(GoalieSituations, areDecidedAsExpected) {
  const test::WrittenSituation<GoalieExpected> written("goalie", GetParam());
  harness.input<RobotPose>().pose = written->robot;
  const BehaviorOutput& output = with(written->ball, written->ballVelocity);
  const GoalieExpected& expected = written.expected();
  const Vec2 goes = output.skill == Skill::stand ? written->robot.position : output.target.position;
  EXPECT_LT((goes - expected.place).norm(), expected.within) << "it goes to " << goes.transpose();
  if (expected.fromTheWay) {  // of the ball
    const Vec2 to = goes - written->ball, way = written->ballVelocity.normalized();
    EXPECT_LT(std::abs(way.x() * to.y() - way.y() * to.x()), *expected.fromTheWay)
        << "it goes to " << goes.transpose();
  }
}

INSTANTIATE_TEST_SUITE_P(Written, GoalieSituations, testing::ValuesIn(test::situationNames("goalie")),
                         test::situationName);

}  // namespace
