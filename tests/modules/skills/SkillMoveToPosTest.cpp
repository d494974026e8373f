#include "modules/skills/SkillMoveToPos.h"

#include <gtest/gtest.h>

#include "framework/ConfigFile.h"
#include "modules/motion/WalkConfig.h"
#include "modules/skills/SkillWish.h"
#include "walking/planning/SpeedControl.h"

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

// A walk sprints only if nearly its full speed is asked for.
TEST(SkillMoveToPos, sprintsToAPlaceFarAheadWithTheWalkOfEveryType) {
  for (const char* type : {"0", "1", "2", "3", "4"}) {
    const std::vector<std::string> folders{"config", std::string("config/robots/simspark_type") + type};
    ConfigStore store(folders);
    const walking::WalkParameters walk = readWalkGaits(Config(store, "walking")).base;
    test::ModuleHarness<SkillMoveToPos> harness(folders);
    test::wish(harness, Skill::moveToPos, Pose2(8, 0, 0));
    Pose2& robot = harness.input<RobotPose>().pose;
    walking::SpeedControl speed;
    constexpr double dt = 0.02;
    for (double time = 0; time < 3; time += dt) {
      harness.cycle();
      const SkillOutput& output = harness.output<SkillMoveToPosOutput>();
      speed.update(output.walkVelocity, output.walkTurn, walk, 1, dt);
      robot.position += dt * speed.velocity();
    }
    EXPECT_GT(speed.velocity().x(), 0.99 * walk.speed.maxForward) << "type " << type;
  }
}

}  // namespace
