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

// The own penalty area begins at -13.2 m and is 6 m wide.
TEST(BehaviorCombinator, whoMayNotBeInTheOwnAreaLeavesItOrWaitsBeforeIt) {
  test::ModuleHarness<BehaviorCombinator> harness;
  BehaviorOutput& striker = harness.input<StrikerOutput>();
  harness.input<FieldDimensions>();
  Pose2& robot = harness.input<RobotPose>().pose;
  harness.input<RobotPose>().valid = true;
  PlayerRole& role = harness.input<PlayerRole>();
  striker.active = true;
  striker.skill = Skill::moveToPos;
  striker.target = Pose2(-14, 1, 0);
  robot = Pose2(-10, 1, 0);
  const SkillRequest& request = harness.output<SkillRequest>();
  harness.cycle();
  EXPECT_EQ(request.target.position, Vec2(-14, 1));
  role.mayBeInOwnArea = false;
  harness.cycle();
  EXPECT_LT((request.target.position - Vec2(-12.6, 1)).norm(), 1e-9);
  // Whatever it wants: within the area it walks out.
  robot = Pose2(-14, 2.8, 0);
  for (const char* skill : {Skill::kick, Skill::dribble, Skill::stand}) {
    striker.skill = skill;
    harness.cycle();
    EXPECT_EQ(request.skill, Skill::moveToPos) << skill;
    EXPECT_LT((request.target.position - Vec2(-14, 3.6)).norm(), 1e-9) << skill;
  }
  striker.skill = Skill::moveToPos;
  striker.target = Pose2(-5, -3, 0);
  harness.cycle();
  EXPECT_EQ(request.target.position, Vec2(-5, -3)) << "it is on its way out already";
  robot = Pose2(-12.6, 1, 0);
  striker.skill = Skill::kick;
  harness.cycle();
  EXPECT_EQ(request.skill, Skill::kick) << "from outside";
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
