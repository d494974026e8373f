#include "tactics/approach/WalkToPose.h"

#include <gtest/gtest.h>

using namespace plumbline;

namespace {

const WalkToPoseParameters parameters{.maxForward = 0.5,
                                      .maxBackward = 0.3,
                                      .maxSideways = 0.2,
                                      .maxTurn = 1.5,
                                      .positionGain = 1.5,
                                      .headingGain = 2,
                                      .nearDistance = 0.6,
                                      .turnFirst = 1};

TEST(WalkToPose, keepsDirectionWhenLimiting) {
  const WalkToPoseParameters limits{.maxForward = 0.5, .maxBackward = 0.3, .maxSideways = 0.2};
  EXPECT_TRUE(limitVelocity({0.1, 0.05}, limits).isApprox(Vec2(0.1, 0.05)));
  EXPECT_NEAR(limitVelocity({9, 0}, limits).x(), 0.5, 1e-12);
  EXPECT_NEAR(limitVelocity({-9, 0}, limits).x(), -0.3, 1e-12);
  const Vec2 diagonal = limitVelocity({5, 2}, limits);
  EXPECT_NEAR(diagonal.y() / diagonal.x(), 0.4, 1e-12);
  EXPECT_NEAR(std::hypot(diagonal.x() / 0.5, diagonal.y() / 0.2), 1, 1e-12);
}

TEST(WalkToPose, turnsFirstToATargetBehind) {
  const WalkCommand command = walkToPose(Pose2(-3, 0.1), parameters);
  EXPECT_EQ(command.velocity.norm(), 0);
  EXPECT_NEAR(command.turn, 1.5, 1e-12);
}

TEST(WalkToPose, mayWalkToATargetThatItStillTurnsTo) {
  WalkToPoseParameters turning = parameters;
  turning.turnWalking = 0.5;
  turning.curveSpeed = 0.4;
  turning.turnEffort = 0.75;
  // A quarter of the curve's speed is left, half of it walks to the left, where the target is.
  const WalkCommand command = walkToPose(Pose2(0, 3), turning);
  EXPECT_NEAR(command.turn, 1.5, 1e-12);
  EXPECT_NEAR(command.velocity.x(), 0, 1e-12);
  EXPECT_NEAR(command.velocity.y(), 0.05, 1e-12);
  EXPECT_EQ(walkToPose(Pose2(3, 0), turning).velocity, walkToPose(Pose2(3, 0), parameters).velocity)
      << "straight ahead";
}

TEST(WalkToPose, walksFastAheadAndTakesTheFinalHeadingNearTheTarget) {
  EXPECT_NEAR(walkToPose(Pose2(3, 0, 2.0), parameters).velocity.x(), 0.5, 1e-12);
  EXPECT_EQ(walkToPose(Pose2(3, 0, 2.0), parameters).turn, 0);
  const WalkCommand near = walkToPose(Pose2(0.1, -0.05, -0.2), parameters);
  EXPECT_NEAR(near.velocity.x(), 0.15, 1e-12);
  EXPECT_NEAR(near.velocity.y(), -0.075, 1e-12);
  EXPECT_NEAR(near.turn, -0.4, 1e-12);
}

/// A walk that hardly turns in a sprint.
WalkToPoseParameters sprinter() {
  return {.maxForward = 1,
          .maxTurn = 2,
          .positionGain = 2,
          .headingGain = 2,
          .nearDistance = 0.5,
          .sprintBearing = 0.12,
          .sprintPassDistance = 0.3,
          .sprintDistance = 1.2,
          .sprintTurn = 0.1,
          .sprintGain = 2,
          .curveSpeed = 0.6};
}

TEST(WalkToPose, sprintsAtATargetStraightAheadAndTurnsWithAGainOfItsOwn) {
  WalkToPoseParameters gentle = sprinter();
  gentle.headingGain = gentle.alignGain = 20;  // would turn to and fro at the limit, which ends in falls
  gentle.sprintGain = 0.5;
  const WalkCommand command = walkToPose(Pose2(4, 0.4), gentle);
  EXPECT_GT(command.velocity.x(), 0.95);
  EXPECT_NEAR(command.turn, 0.5 * std::atan(0.1), 1e-12);
  gentle.sprintGain = 5;
  EXPECT_NEAR(walkToPose(Pose2(4, 0.4), gentle).turn, 0.1, 1e-12) << "sprintTurn is the most";
}

TEST(WalkToPose, turnsToATargetAsideBeforeItSprints) {
  const WalkCommand aside = walkToPose(Pose2(4, 1), sprinter());
  EXPECT_NEAR(aside.turn, 2 * std::atan(0.25), 1e-12);
  // Of its 0.6 m/s a full turn takes four fifths.
  EXPECT_NEAR(aside.velocity.x(), 0.6 * (1 - 0.8 * std::atan(0.25)), 1e-12);
}

/// A fast walk hardly turns: a robot that should sprint turns first.
TEST(WalkToPose, turnsHardAndGoesSlowlyBeforeASprint) {
  WalkToPoseParameters aligning = sprinter();
  aligning.alignSpeed = 0.2;
  aligning.alignGain = 6;
  aligning.turnEffort = 0;
  const Pose2 aside(4, 1);
  EXPECT_NEAR(walkToPose(aside, aligning).turn, 6 * std::atan(0.25), 1e-12);
  EXPECT_NEAR(walkToPose(aside, aligning).velocity.x(), 0.2, 1e-12);
  const Pose2 nearer(1.1, 0.275);  // too near for a sprint
  EXPECT_NEAR(walkToPose(nearer, aligning).turn, 2 * std::atan(0.25), 1e-12);
  EXPECT_GT(walkToPose(nearer, aligning).velocity.x(), 0.5);
  EXPECT_TRUE(walkToPose(Pose2(4, 0.1), aligning).sprint);
}

TEST(WalkToPose, goesOnSprintingWhereItPassesNearEnough) {
  // 0.25 m aside at 1.5 m are 0.165 rad, more than sprintBearing.
  EXPECT_GT(walkToPose(Pose2(1.5, 0.25), sprinter()).velocity.x(), 0.9);
  EXPECT_LT(walkToPose(Pose2(1.5, 0.4), sprinter()).velocity.x(), 0.6);
}

TEST(WalkToPose, leavesTheSprintInTimeToStop) {
  EXPECT_GT(walkToPose(Pose2(1.25, 0), sprinter()).velocity.x(), 0.95);
  EXPECT_NEAR(walkToPose(Pose2(1.15, 0), sprinter()).velocity.x(), 0.6, 1e-12);
}

/// A single cycle farther aside, as the trunk sways, ended a sprint: to brake and begin again takes seconds.
TEST(WalkToPose, aSprintGoesOnWhileTheTargetIsHardlyFartherAside) {
  WalkToPoseParameters holding = sprinter();
  holding.sprintHold = 0.3;
  const Pose2 aside(4, 0.8);  // 0.197 rad
  EXPECT_FALSE(walkToPose(aside, holding).sprint);
  EXPECT_FALSE(walkToPose(aside, sprinter(), true).sprint);
  const WalkCommand held = walkToPose(aside, holding, true);
  EXPECT_TRUE(held.sprint);
  EXPECT_NEAR(held.velocity.x(), 1, 1e-12);  // all of it: the walk takes less for the sprint's end
  EXPECT_NEAR(held.turn, 0.1, 1e-12);
  EXPECT_FALSE(walkToPose(Pose2(4, 1.4), holding, true).sprint);
  EXPECT_FALSE(walkToPose(Pose2(1.1, 0.1), holding, true).sprint);
}

}  // namespace
