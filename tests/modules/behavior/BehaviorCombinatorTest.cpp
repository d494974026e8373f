#include "modules/behavior/BehaviorCombinator.h"

#include <gtest/gtest.h>

#include "representations/behavior/BeforeKickOffOutput.h"
#include "representations/behavior/StrikerOutput.h"
#include "support/ModuleHarness.h"

using namespace plumbline;

namespace {

TEST(BehaviorCombinator, situationsComeBeforeRoles) {
  test::ModuleHarness<BehaviorCombinator> harness;
  BehaviorOutput& before = harness.input<BeforeKickOffOutput>();
  BehaviorOutput& striker = harness.input<StrikerOutput>();
  striker.active = true;
  striker.skill = Skill::kick;
  striker.target = Pose2(15, 0.5);
  harness.cycle();
  EXPECT_EQ(harness.output<SkillRequest>().skill, Skill::kick);
  EXPECT_EQ(harness.output<SkillRequest>().target.x(), 15);
  EXPECT_FALSE(harness.output<BeamRequest>().active);

  before.active = true;
  before.skill = Skill::stand;
  before.beam = true;
  before.beamPose = Pose2(-1, 2, 0.5);
  harness.cycle();
  EXPECT_EQ(harness.output<SkillRequest>().skill, Skill::stand);
  EXPECT_TRUE(harness.output<BeamRequest>().active);
  EXPECT_EQ(harness.output<BeamRequest>().pose.y(), 2);
}

TEST(BehaviorCombinator, standsWhenNobodyWantsAnything) {
  test::ModuleHarness<BehaviorCombinator> harness;
  harness.input<BeforeKickOffOutput>();
  harness.input<StrikerOutput>();
  harness.cycle();
  EXPECT_EQ(harness.output<SkillRequest>().skill, Skill::stand);
}

/// A behaviour that no file of the project names.
REPRESENTATION_OF(GoalieOutput, BehaviorOutput)
class GoalieOutput : public GoalieOutputBase {};

TEST(BehaviorCombinator, asksTheBehavioursInTheOrderOfTheLines) {
  test::ModuleHarness<BehaviorCombinator> harness;
  BehaviorOutput& goalie = harness.input<GoalieOutput>();
  BehaviorOutput& striker = harness.input<StrikerOutput>();
  goalie.active = striker.active = true;
  goalie.skill = "dive";
  striker.skill = Skill::kick;
  harness.cycle();
  EXPECT_EQ(harness.output<SkillRequest>().skill, "dive");
}

}  // namespace
