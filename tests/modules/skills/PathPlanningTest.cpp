#include "modules/skills/PathPlanning.h"

#include <gtest/gtest.h>

#include "modules/skills/SkillWish.h"
#include "representations/skills/SkillKickOutput.h"
#include "representations/skills/SkillMoveToPosOutput.h"
#include "support/DrawnBy.h"
#include "support/ModuleHarness.h"
#include "support/Robots.h"

namespace plumbline {
namespace {

/// Number 4 at the origin, which wants to walk 4 m along x.
class PathPlanningTest : public testing::Test {
protected:
  PathPlanningTest() {
    harness.input<FrameInfo>().time = 10;
    harness.input<FieldDimensions>();
    harness.input<PlayerInfo>().number = 4;
    harness.input<SkillKickOutput>();
    harness.input<SkillMoveToPosOutput>();
    role.role = PlayerRole::supporter;
    pose.valid = true;
    test::wish(harness, Skill::moveToPos, Pose2(4, 0, 0));
  }
  OtherRobot& standsAt(const Vec2& place, bool mate = false, int number = 3) {
    OtherRobot& robot = test::addRobot(harness.input<OtherRobots>().robots, mate, place, number);
    robot.lastSeen = 10;
    return robot;
  }
  void ballAt(const Vec2& place) {
    harness.input<BallPos>().field = place;
    harness.input<BallPos>().valid = true;
  }
  const SafeWalkDirection& way() {
    harness.cycle();
    return harness.output<SafeWalkDirection>();
  }
  test::ModuleHarness<PathPlanning> harness;
  PlayerRole& role = harness.input<PlayerRole>();
  RobotPose& pose = harness.input<RobotPose>();
};

TEST_F(PathPlanningTest, goesStraightWhereNobodyStands) {
  EXPECT_FALSE(way().detour);
  EXPECT_EQ(way().wayPointField, Vec2(4, 0));
  EXPECT_FALSE(way().wait);
}

TEST_F(PathPlanningTest, goesRoundARobotAndKeepsItsRadius) {
  standsAt({2, 0});
  EXPECT_TRUE(way().detour);
  EXPECT_GE(distanceToSegment(Vec2(2, 0), Vec2(0, 0), way().wayPointField), 0.5 - 1e-9);
  pose.pose = Pose2(0, 0, pi / 2);
  const SafeWalkDirection turned = way();
  EXPECT_NEAR(turned.wayPoint.x(), turned.wayPointField.y(), 1e-9) << "relative to the robot";
  EXPECT_NEAR(turned.wayPoint.y(), -turned.wayPointField.x(), 1e-9);
}

TEST_F(PathPlanningTest, oneSeenLongAgoIsNoObstacleAndOneThatWalksIsWhereItWillBe) {
  OtherRobot& robot = standsAt({2, 0});
  robot.velocity = {0, 1};
  EXPECT_FALSE(way().detour) << "a metre off the way by then";
  robot.velocity.setZero();
  robot.lastSeen = 6.9;
  EXPECT_FALSE(way().detour);
  robot.lastSeen = 7.1;
  EXPECT_TRUE(way().detour);
}

TEST_F(PathPlanningTest, keepsOffTheBallUnlessItGoesThere) {
  ballAt({2, 0});
  EXPECT_TRUE(way().detour);
  test::wish(harness, Skill::kick, Pose2(10, 0, 0));
  EXPECT_FALSE(way().detour);
  EXPECT_EQ(way().wayPointField, Vec2(2, 0));
  standsAt({2.5, 0});
  EXPECT_FALSE(way().detour) << "who has the ball is the one to go to";
}

TEST_F(PathPlanningTest, keepsOffTheGoalPosts) {
  pose.pose = Pose2(14, 1.05, 0);
  test::wish(harness, Skill::moveToPos, Pose2(16, 1.05, 0));
  EXPECT_TRUE(way().detour);
}

// The own penalty area begins at -13.2 m and is 6 m wide.
TEST_F(PathPlanningTest, leadsThroughTheOwnAreaOnlyWhoMayBeThere) {
  pose.pose = Pose2(-14, 4, 0);
  test::wish(harness, Skill::moveToPos, Pose2(-14, -4, 0));
  EXPECT_FALSE(way().detour);
  role.mayBeInOwnArea = false;
  for (int i = 0; i < 2000 && (pose.pose.position - Vec2(-14, -4)).norm() > 0.1; ++i) {
    const Vec2 step = way().wayPointField - pose.pose.position;
    pose.pose.position += std::min(0.05, step.norm()) * step.normalized();
    ASSERT_GT(OwnArea(FieldSize()).distance(pose.pose.position), OwnArea::passDistance - 1e-6);
  }
  EXPECT_LT((pose.pose.position - Vec2(-14, -4)).norm(), 0.11);
  // Who is within walks straight out.
  pose.pose = Pose2(-14, 2, 0);
  EXPECT_FALSE(way().detour);
}

TEST_F(PathPlanningTest, mateWithALowerNumberAndTheStrikerCrossFirst) {
  OtherRobot& mate = standsAt({0.5, 0.1}, true, 3);
  mate.velocity = {0, 1};  // it crosses, and the way is free when this robot is there
  EXPECT_TRUE(way().wait);
  mate.number = 5;
  EXPECT_FALSE(way().wait);
  role.strikerNumber = 5;
  EXPECT_TRUE(way().wait);
  mate.position = {-0.5, 0.1};
  EXPECT_FALSE(way().wait) << "behind its back";
  mate.position = {0.7, 0.1};
  EXPECT_FALSE(way().wait) << "0.6 m and more away";
  mate.position = {0.5, 0.1};
  mate.fallen = true;
  EXPECT_FALSE(way().wait) << "it lies there for long";
  mate.fallen = false;
  role.role = PlayerRole::striker;
  EXPECT_FALSE(way().wait);
}

TEST_F(PathPlanningTest, withoutAPlaceABallOrAWishThereIsNoWay) {
  standsAt({2, 0});
  pose.valid = false;
  EXPECT_FALSE(way().detour);
  EXPECT_EQ(way().wayPointField, Vec2(0, 0));
  pose.valid = true;
  test::wish(harness, Skill::kick, Pose2(10, 0, 0));
  EXPECT_EQ(way().wayPointField, Vec2(0, 0)) << "the ball is not known";
  test::wish(harness, Skill::stand, Pose2(10, 0, 0));
  ballAt({4, 0});
  EXPECT_EQ(way().wayPointField, Vec2(0, 0));
}

TEST_F(PathPlanningTest, theWayAndWhatStandsNearItAreDrawn) {
  standsAt({2, 0});
  standsAt({2, 9}, true, 5);
  const Drawing drawing = test::drawnBy("draw:team:way", [&] { way(); });
  EXPECT_EQ(test::countOf<shapes::Circle>(drawing), 1u) << "who is far from the way is left out";
  const auto& first = std::get<shapes::Line>(drawing.shapes()[1].form);
  EXPECT_EQ(first.begin, Vec3(0, 0, 0));
  EXPECT_NE(first.end.y(), 0) << "round the robot";
  const auto& goal = std::get<shapes::Point>(drawing.shapes()[drawing.shapes().size() - 4].form);
  EXPECT_EQ(goal.position, Vec3(4, 0, 0));
  for (int i = 0; i < 500; ++i) standsAt({2, 0.01 * i}, false, i);
  EXPECT_LT(test::drawnBy("draw:team:way", [&] { way(); }).shapes().size(), 100u) << "bounded";
  test::wish(harness, Skill::stand, Pose2());
  EXPECT_TRUE(test::drawnBy("draw:team:way", [&] { way(); }).shapes().empty());
}

}  // namespace
}  // namespace plumbline
