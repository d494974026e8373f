#include "modules/skills/SkillKick.h"

#include <gtest/gtest.h>

#include "representations/behavior/SkillRequest.h"
#include "support/ModuleHarness.h"

using namespace plumbline;

namespace {

TEST(SkillKick, kicksOnceItIsAtTheBall) {
  test::ModuleHarness<SkillKick> harness;
  harness.input<SkillRequest>().skill = Skill::kick;
  SkillGetBallOutput& getBall = harness.input<SkillGetBallOutput>();
  getBall.motion = Motion::walk;
  getBall.kickFoot = Side::left;
  getBall.kick = "kickRight";
  harness.cycle();
  const SkillOutput& output = harness.output<SkillKickOutput>();
  EXPECT_TRUE(output.active);
  EXPECT_EQ(output.motion, Motion::walk);
  getBall.atBall = true;
  harness.cycle();
  EXPECT_EQ(output.motion, Motion::kick);
  EXPECT_EQ(output.kickFoot, Side::left);
  EXPECT_EQ(output.kick, "kickRight");
  EXPECT_FALSE(output.atOnce) << "from a walk that has come to rest";
  getBall.pressed = true;
  harness.cycle();
  EXPECT_FALSE(output.atOnce) << "in a duel too";
  harness.input<SkillRequest>().skill = Skill::dribble;
  harness.cycle();
  EXPECT_FALSE(output.active);
}

}  // namespace
