#include "modules/skills/SkillCombinator.h"

#include <gtest/gtest.h>

#include "representations/skills/SkillDribbleOutput.h"
#include "representations/skills/SkillGetBallOutput.h"
#include "representations/skills/SkillKickOutput.h"
#include "representations/skills/SkillMoveToPosOutput.h"
#include "support/ModuleHarness.h"

using namespace plumbline;

namespace {

void dribbleWith(test::ModuleHarness<SkillCombinator>& harness, const Vec2& velocity) {
  SkillOutput& dribble = harness.input<SkillDribbleOutput>();
  dribble.active = true;
  dribble.motion = Motion::walk;
  dribble.walkVelocity = velocity;
}

TEST(SkillCombinator, takesTheActiveSkillOrStands) {
  test::ModuleHarness<SkillCombinator> harness;
  harness.input<SkillMoveToPosOutput>();
  harness.input<SkillGetBallOutput>();
  harness.input<SkillKickOutput>();
  SkillOutput& dribble = harness.input<SkillDribbleOutput>();
  harness.cycle();
  EXPECT_EQ(harness.output<MotionRequest>().motion, Motion::stand);
  dribble.active = true;
  dribble.motion = Motion::walk;
  dribble.walkVelocity = {0.3, 0.1};
  dribble.walkTurn = -0.2;
  harness.cycle();
  EXPECT_EQ(harness.output<MotionRequest>().motion, Motion::walk);
  EXPECT_EQ(harness.output<MotionRequest>().walkVelocity.x(), 0.3);
  EXPECT_EQ(harness.output<MotionRequest>().walkTurn, -0.2);
  dribble.active = false;
  harness.cycle();
  EXPECT_EQ(harness.output<MotionRequest>().motion, Motion::stand);
  EXPECT_EQ(harness.output<MotionRequest>().walkVelocity.norm(), 0);
}

TEST(SkillCombinator, walksIntoNoOpponentThatHasTheBall) {
  test::ModuleHarness<SkillCombinator> harness;
  dribbleWith(harness, {1, 0});
  harness.input<RobotPose>() = {};
  harness.input<RobotPose>().pose = Pose2(2, 3, pi / 2);
  harness.input<RobotPose>().valid = true;
  harness.input<BallPos>().relative = {0.8, 0};
  OtherRobot opponent;
  opponent.position = {2, 3.5};
  harness.input<OtherRobots>().robots = {opponent};
  harness.cycle();
  EXPECT_NEAR(harness.output<MotionRequest>().walkVelocity.x(), 0.4, 1e-9);
  harness.input<OtherRobots>().robots[0].fallen = true;
  harness.cycle();
  EXPECT_EQ(harness.output<MotionRequest>().walkVelocity.x(), 1);
}

// The own penalty area begins at -13.2 m.
TEST(SkillCombinator, stopsBeforeTheOwnAreaWithoutTheRightToBeThere) {
  test::ModuleHarness<SkillCombinator> harness;
  dribbleWith(harness, {1, 0.2});
  harness.input<FieldDimensions>();
  harness.input<RobotPose>().pose = Pose2(-12.9, 1, pi);
  harness.input<RobotPose>().valid = true;
  PlayerRole& role = harness.input<PlayerRole>();
  const Vec2& velocity = harness.output<MotionRequest>().walkVelocity;
  harness.cycle();
  EXPECT_LT((velocity - Vec2(1, 0.2)).norm(), 1e-9);
  role.mayBeInOwnArea = false;
  harness.cycle();
  EXPECT_LT(velocity.x(), 0.15);
  EXPECT_NEAR(velocity.y(), 0.2, 1e-9) << "along it";
  harness.input<RobotPose>().valid = false;
  harness.cycle();
  EXPECT_LT((velocity - Vec2(1, 0.2)).norm(), 1e-9) << "it does not know where it is";
}

}  // namespace
