#include "modules/modeling/BeliefCombinator.h"

#include <gtest/gtest.h>

#include <cmath>

#include "math/Angle.h"
#include "modules/modeling/others/RobotDrawing.h"
#include "support/DrawnBy.h"
#include "support/ModuleHarness.h"
#include "support/Robots.h"

namespace plumbline {
namespace {

/// A robot at (2, 3) that looks along the field's y axis.
class BeliefCombinatorTest : public testing::Test {
protected:
  BeliefCombinatorTest() {
    frame.time = 10;
    robot.pose = Pose2(2, 3, pi / 2);
    robot.valid = true;
    local.valid = true;
    local.position = {1, 0};
    local.lastSeen = 10;
  }
  const BallPos& ballAfter(double seconds) {
    frame.time += seconds;
    frame.cycleSeconds = seconds;
    harness.cycle();
    return ball;
  }
  test::ModuleHarness<BeliefCombinator> harness;
  FrameInfo& frame = harness.input<FrameInfo>();
  RobotPose& robot = harness.input<RobotPose>();
  LocalBallPos& local = harness.input<LocalBallPos>();
  TeamBallPos& team = harness.input<TeamBallPos>();
  const BallPos& ball = harness.output<BallPos>();
};

TEST_F(BeliefCombinatorTest, aSeenBallIsPlacedOnTheField) {
  local.velocity = {0, -1};
  ballAfter(0);
  EXPECT_TRUE(ball.valid);
  EXPECT_EQ(ball.age, 0);
  EXPECT_NEAR((ball.field - Vec2(2, 4)).norm(), 0, 1e-12);
  EXPECT_NEAR((ball.relative - Vec2(1, 0)).norm(), 0, 1e-12);
  EXPECT_NEAR((ball.relativeVelocity - Vec2(0, -1)).norm(), 0, 1e-12);
}

TEST_F(BeliefCombinatorTest, anUnseenBallStaysOnTheFieldAndRollsOut) {
  local.velocity = {1, 0};
  ballAfter(0);
  robot.pose = Pose2(0, 0, 0);  // the localisation jumps
  ballAfter(0.5);
  const double rolled = 0.92 * (1 - std::exp(-0.5 / 0.92));
  EXPECT_NEAR((ball.field - Vec2(2, 4 + rolled)).norm(), 0, 1e-9);
  EXPECT_NEAR((ball.relative - ball.field).norm(), 0, 1e-9);
  EXPECT_NEAR(ball.relativeVelocity.y(), std::exp(-0.5 / 0.92), 1e-9);
  EXPECT_NEAR(ball.age, 0.5, 1e-9);
}

TEST_F(BeliefCombinatorTest, withoutAPlaceOrAfterARestartOnlyWhatIsRelativeCounts) {
  ballAfter(0);
  robot.valid = false;
  robot.pose = Pose2(7, 7, 0);
  local.position = {0, 2};
  ballAfter(0.5);
  EXPECT_NEAR((ball.relative - Vec2(0, 2)).norm(), 0, 1e-9);
  robot.valid = true;
  local.lastSeen = frame.time;
  ballAfter(0);
  frame.restarted = true;
  local.position = {3, 0};
  ballAfter(0.5);
  EXPECT_NEAR((ball.relative - Vec2(3, 0)).norm(), 0, 1e-9);
}

TEST_F(BeliefCombinatorTest, aMatesBallCountsIfItWasSeenLaterAndTheOwnIsOld) {
  team.valid = true;
  team.field = {-5, 0};
  team.velocity = {0, 1};
  team.age = 0.1;
  EXPECT_NEAR(ballAfter(0.5).field.x(), 2, 1e-9) << "seen 0.5 s ago itself";
  ballAfter(0.2);
  EXPECT_EQ(ball.field, Vec2(-5, 0));
  EXPECT_EQ(ball.age, 0.1);
  EXPECT_NEAR((ball.relativeVelocity - Vec2(1, 0)).norm(), 0, 1e-12);
  team.age = 0.9;
  local.position = {1, 1};
  local.lastSeen = frame.time;
  EXPECT_NEAR(ballAfter(0.7).field.x(), -5, 1e-9) << "kept where it was heard to be, as both are old";
  robot.valid = false;
  team.age = 0.1;
  EXPECT_NEAR((ballAfter(0).relative - Vec2(1, 1)).norm(), 0, 1e-9) << "without a place it is of no use";
}

TEST_F(BeliefCombinatorTest, aBallThatNobodyEverSawIsNotValid) {
  local = {};
  EXPECT_FALSE(ballAfter(0.02).valid);
  EXPECT_EQ(ball.age, 1e3);
  team.valid = true;
  team.age = 5;
  EXPECT_TRUE(ballAfter(0.02).valid);
}

TEST_F(BeliefCombinatorTest, robotsAreThoseSeenAndThoseHeardOf) {
  OtherRobot& seen = test::addRobot(harness.input<LocalOtherRobots>().robots, false, {1, 0}, 4);
  seen.lastSeen = 9.9;
  std::vector<OtherRobot>& heard = harness.input<TeamOtherRobots>().robots;
  test::addRobot(heard, false, {1.2, 0}, 4).lastSeen = 9.95;
  test::addRobot(heard, true, {-3, 0}, 7).lastSeen = 9.95;
  harness.cycle();
  const std::vector<OtherRobot>& robots = harness.output<OtherRobots>().robots;
  ASSERT_EQ(robots.size(), 2u);
  EXPECT_EQ(robots[0].position, Vec2(1, 0)) << "seen just now";
  EXPECT_EQ(robots[1].number, 7);
  seen.lastSeen = 9.6;
  harness.cycle();
  EXPECT_NEAR(robots[0].position.x(), 1.1, 1e-9) << "both are as sure";
}

/// The radius of the circle in that colour; -1: there is none.
double radiusIn(const Drawing& drawing, const shapes::Colour& colour) {
  for (const shapes::Shape& shape : drawing.shapes())
    if (const auto* circle = std::get_if<shapes::Circle>(&shape.form); circle && shape.colour == colour)
      return circle->radius;
  return -1;
}

TEST_F(BeliefCombinatorTest, theBallIsDrawnByOwnSightAndByWordsInTheirColours) {
  local.deviation = 0.1;
  const auto drawn = [&] { return test::drawnBy("draw:belief:ball", [&] { ballAfter(0); }); };
  EXPECT_EQ(radiusIn(drawn(), beliefColours::sight), 0.2);
  EXPECT_EQ(radiusIn(drawn(), beliefColours::heard), -1);
  team.valid = true;
  team.deviation = 0.5;
  const Drawing both = drawn();
  EXPECT_EQ(radiusIn(both, beliefColours::sight), 0.2);
  EXPECT_EQ(radiusIn(both, beliefColours::heard), 1);
  EXPECT_TRUE(test::placeOf(both, "ball 0.0 s").isApprox(Vec3(2, 4, 0)));
  local.valid = team.valid = false;
  EXPECT_TRUE(drawn().shapes().empty());
}

TEST_F(BeliefCombinatorTest, theRobotsAreDrawn) {
  test::addRobot(harness.input<LocalOtherRobots>().robots, true, {1, 1}, 5);
  const Drawing drawing = test::drawnBy("draw:belief:robots", [&] { ballAfter(0); });
  EXPECT_EQ(test::placeOf(drawing, "mate 5"), Vec3(1, 1, 0));
}

}  // namespace
}  // namespace plumbline
