#include "modules/skills/SkillDive.h"

#include <gtest/gtest.h>

#include "modules/skills/SkillWish.h"

using namespace plumbline;

namespace {

TEST(SkillDive, goesToTheSideOfItsTarget) {
  test::ModuleHarness<SkillDive> harness;
  harness.input<RobotPose>().pose = Pose2(-14, 0, 1.5);
  test::wish(harness, Skill::dive, Pose2(-14.5, 0.1, 0));
  harness.cycle();
  const SkillOutput& output = harness.output<SkillDiveOutput>();
  EXPECT_TRUE(output.active);
  EXPECT_EQ(output.motion, Motion::specialAction);
  EXPECT_EQ(output.specialAction, "diveLeft");
  EXPECT_TRUE(output.atOnce);
  test::wish(harness, Skill::dive, Pose2(-13.5, 0.1, 0));
  harness.cycle();
  EXPECT_EQ(output.specialAction, "diveRight");
  harness.input<SkillRequest>().skill = Skill::moveToPos;
  harness.cycle();
  EXPECT_FALSE(output.active);
}

TEST(SkillDive, itsMotionsAreParameters) {
  test::ModuleHarness<SkillDive> harness;
  harness.input<RobotPose>();
  test::wish(harness, Skill::dive, Pose2(1, 0, 0));
  harness.module().right = "fall";
  harness.cycle();
  EXPECT_EQ(harness.output<SkillDiveOutput>().specialAction, "fall") << "straight ahead is to the right";
}

}  // namespace
