#include "tactics/approach/BallPositioning.h"

#include <gtest/gtest.h>

#include "tactics/approach/SomeWalk.h"

using namespace plumbline;

namespace {

const WalkLimits& walk = test::someWalk;

struct BallPositioningTest : testing::Test {
  BallPositioningTest() {
    p.toleranceForward = 0.03;
    p.toleranceSideways = 0.02;
    p.toleranceHeading = 0.15;
    p.leaveTolerances = 1.5;
  }
  /// The robot is to have the ball at (0.2, 0) and looks where it is to look, off by `heading`.
  WalkCommand see(const Vec2& ball, double heading = 0) {
    wish.ball = ball;
    wish.heading = heading;
    return positioning.update(wish, ball, p, 0.02);
  }
  bool atBall(const Vec2& ball, double heading = 0) {
    see(ball, heading);
    return positioning.atBall();
  }

  BallPositioningParameters p;
  BallPositioning::Wish wish{.place = Vec2(0.2, 0)};
  BallPositioning positioning;
};

TEST_F(BallPositioningTest, isAtTheBallWithinItsTolerancesAndStaysThereALittleLonger) {
  EXPECT_FALSE(atBall({0.24, 0}));
  EXPECT_FALSE(atBall({0.2, 0.025}));
  EXPECT_FALSE(atBall({0.2, 0}, 0.2));
  EXPECT_TRUE(atBall({0.22, 0.015}, 0.1));
  EXPECT_TRUE(atBall({0.24, 0.025}, 0.2)) << "within 1.5 tolerances";
  EXPECT_FALSE(atBall({0.25, 0}));
  EXPECT_FALSE(atBall({0.24, 0})) << "not there any more";
}

TEST_F(BallPositioningTest, aHurryMakesTheTolerancesLarger) {
  wish.hurry = 2;
  EXPECT_TRUE(atBall({0.25, 0.035}, 0.25));
  positioning.leave();
  wish.headingTolerance = 0.05;
  EXPECT_FALSE(atBall({0.25, 0.035}, 0.06)) << "what was asked for the heading is not enlarged";
}

TEST_F(BallPositioningTest, aRobotThatLeftTheBallHasToStandExactlyAgain) {
  EXPECT_TRUE(atBall({0.2, 0}));
  positioning.leave();
  EXPECT_FALSE(atBall({0.24, 0}));
}

TEST_F(BallPositioningTest, whatIsSeenDecidesAndWhereTheBallWillBeIsWalkedTo) {
  wish.ball = Vec2(1, 0);
  const WalkCommand command = positioning.update(wish, Vec2(0.2, 0), p, 0.02);
  EXPECT_TRUE(positioning.atBall());
  EXPECT_GT(command.velocity.x(), 0.3);
}

TEST_F(BallPositioningTest, learnsADriftNearTheBallAndForgetsItFarAway) {
  p.biasGain = 1;
  p.maxBias = 0.05;
  p.walk.positionGain = 2;
  const double first = see({0.25, 0}).velocity.x();
  EXPECT_NEAR(first, 0.1 + 0.02 * 0.05, 1e-9);
  double last = 0;
  for (int i = 0; i < 200; ++i) last = see({0.25, 0}).velocity.x();
  EXPECT_NEAR(last, 0.15, 1e-9) << "the largest drift";
  see({1, 0});
  EXPECT_NEAR(see({0.25, 0}).velocity.x(), first, 1e-9);
}

TEST_F(BallPositioningTest, aDribblerBehindTheBallAimsBeyondIt) {
  const double without = see({0.3, 0}).velocity.x();
  wish.beyond = 0.2;
  EXPECT_GT(see({0.3, 0}).velocity.x(), without + 0.1);
}

// Beyond is along the wanted heading, so 0.2 m beyond a ball is where a ball that is 0.2 m farther would be.
TEST_F(BallPositioningTest, aDribblerThatLooksAsideAimsBeyondTheBallAlongItsLine) {
  p.biasGain = 0;
  const Vec2 ball(0.4, 0), along(std::cos(0.3), std::sin(0.3));
  const Vec2 farther = see(ball + 0.2 * along, 0.3).velocity;
  wish.beyond = 0.2;
  const Vec2 beyond = see(ball, 0.3).velocity;
  EXPECT_LT((beyond - farther).norm(), 1e-9) << beyond.transpose() << " not " << farther.transpose();
}

TEST_F(BallPositioningTest, aDribblerOnItsWayAroundTheBallDoesNotAimBeyondIt) {
  p.biasGain = 0;
  const Vec2 without = see({-0.4, 0}).velocity;
  wish.beyond = 0.2;
  EXPECT_LT((see({-0.4, 0}).velocity - without).norm(), 1e-9);
}

TEST_F(BallPositioningTest, aDetourComesFirst) {
  wish.detour = Vec2(0, 2);
  EXPECT_GT(see({3, 0}).turn, 0.5);
}

TEST_F(BallPositioningTest, theLastMetresArePlannedWhereTheWalkIsKnown) {
  p.walk.maxBackward = 0.1;
  const Vec2 behind(-0.5, 0);
  EXPECT_GE(see(behind).velocity.x(), -0.1) << "no faster than it may walk backward";
  EXPECT_EQ(positioning.planner().seconds(), 0);
  wish.limits = walk;
  EXPECT_LT(see(behind).velocity.x(), -0.1) << "the robot walks back past the ball";
  EXPECT_GT(positioning.planner().seconds(), 1);
  EXPECT_EQ(see({3, 0}).velocity.x(), p.walk.maxForward) << "far away";
  wish.detour = Vec2(0, 2);
  EXPECT_EQ(see(behind).velocity.x(), 0) << "a detour comes first";
}

TEST_F(BallPositioningTest, aSprintGoesOnUntilItIsNearerToTheBall) {
  p.walk.sprintBearing = 0.2;
  p.walk.sprintDistance = 0.5;
  p.walk.maxForward = 1.5;
  p.plan.sprintDistance = 1;
  wish.limits = walk;
  EXPECT_LT(see({1.5, 0}).velocity.x(), 0.7) << "no sprint so near";
  EXPECT_EQ(see({2.5, 0}).velocity.x(), 1.5);
  EXPECT_EQ(see({1.5, 0}).velocity.x(), 1.5);
  EXPECT_LT(see({0.9, 0}).velocity.x(), 0.7);
}

}  // namespace
