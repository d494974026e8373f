#include "modules/skills/SkillMoveToPos.h"

#include <gtest/gtest.h>

#include "modules/skills/SkillWish.h"

using namespace plumbline;

namespace {

TEST(SkillMoveToPos, walksThereAndStands) {
  test::ModuleHarness<SkillMoveToPos> harness;
  test::wish(harness, Skill::moveToPos, Pose2(2, 1, 0.5));
  harness.input<RobotPose>().pose = Pose2(0, 1, 0);
  harness.cycle();
  const SkillOutput& output = harness.output<SkillMoveToPosOutput>();
  EXPECT_TRUE(output.active);
  EXPECT_EQ(output.motion, Motion::walk);
  EXPECT_GT(output.walkVelocity.x(), 0.3);
  harness.input<RobotPose>().pose = Pose2(2.02, 1.01, 0.45);
  harness.cycle();
  EXPECT_TRUE(output.active);
  EXPECT_EQ(output.motion, Motion::stand);
  // Twice the tolerance away it still stands, five times it walks.
  harness.input<RobotPose>().pose = Pose2(2.1, 1, 0.5);
  harness.cycle();
  EXPECT_EQ(output.motion, Motion::stand);
  harness.input<RobotPose>().pose = Pose2(2.25, 1, 0.5);
  harness.cycle();
  EXPECT_EQ(output.motion, Motion::walk);
  EXPECT_LT(output.walkVelocity.x(), 0);
}

TEST(SkillMoveToPos, isInactiveForOtherSkills) {
  test::ModuleHarness<SkillMoveToPos> harness;
  harness.input<SkillRequest>().skill = Skill::kick;
  harness.input<RobotPose>();
  harness.cycle();
  EXPECT_FALSE(harness.output<SkillMoveToPosOutput>().active);
}

TEST(SkillMoveToPos, walksRoundOthersAndWaitsForThem) {
  test::ModuleHarness<SkillMoveToPos> harness;
  test::wish(harness, Skill::moveToPos, Pose2(3, 0, 0));
  harness.input<RobotPose>().pose = Pose2();
  SafeWalkDirection& safe = harness.input<SafeWalkDirection>();
  harness.cycle();
  EXPECT_EQ(harness.output<SkillMoveToPosOutput>().walkVelocity.y(), 0);
  EXPECT_NEAR(harness.output<SkillMoveToPosOutput>().walkTurn, 0, 1e-9);
  safe.detour = true;
  safe.wayPoint = {0, 2};
  harness.cycle();
  EXPECT_GT(harness.output<SkillMoveToPosOutput>().walkTurn, 0.5) << "to the corner on the left";
  safe.wait = true;
  harness.cycle();
  EXPECT_TRUE(harness.output<SkillMoveToPosOutput>().active);
  EXPECT_EQ(harness.output<SkillMoveToPosOutput>().motion, Motion::stand);
  EXPECT_EQ(harness.output<SkillMoveToPosOutput>().walkTurn, 0);
}

}  // namespace
