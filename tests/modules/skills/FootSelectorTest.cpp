#include "modules/skills/FootSelector.h"

#include <gtest/gtest.h>

#include "representations/skills/SkillGetBallOutput.h"
#include "representations/skills/SkillKickOutput.h"
#include "support/ModuleHarness.h"

using namespace plumbline;

namespace {

/// The ball lies in the field's middle and shall go along x.
struct FootSelectorTest : testing::Test {
  FootSelectorTest() {
    harness.input<SkillRequest>().skill = Skill::kick;
    harness.input<SkillRequest>().target = Pose2(10, 0, 0);
    harness.input<BallPos>().field = Vec2::Zero();
    harness.input<OtherRobots>();
    harness.input<SkillKickOutput>();
    harness.input<SkillGetBallOutput>();
  }
  Side footFrom(const Vec2& place) {
    harness.input<RobotPose>().pose = Pose2(place, 0);
    harness.cycle();
    return harness.output<ActiveFoot>().foot;
  }
  test::ModuleHarness<FootSelector> harness;
};

TEST_F(FootSelectorTest, takesTheFootThatIsBehindTheBallSooner) {
  EXPECT_EQ(footFrom({-1, 0.2}), Side::right);
  EXPECT_EQ(footFrom({-1, -0.2}), Side::left);
  EXPECT_EQ(footFrom({0.3, 0.5}), Side::right) << "also before it has gone round the ball";
}

TEST_F(FootSelectorTest, isReluctantToChange) {
  EXPECT_EQ(footFrom({-0.2, -0.05}), Side::left);
  EXPECT_EQ(footFrom({-0.2, 0.02}), Side::left);
  EXPECT_EQ(footFrom({-0.2, 0.04}), Side::right);
}

TEST_F(FootSelectorTest, goesByWhereTheBallIsToGo) {
  harness.input<SkillRequest>().target = Pose2(0, -10, 0);
  EXPECT_EQ(footFrom({-0.5, 0.5}), Side::left) << "to the right of a way along -y";
  harness.input<SkillRequest>().skill = Skill::getBall;
  EXPECT_EQ(footFrom({-0.5, 0.5}), Side::right) << "the heading of the request, along x";
}

TEST_F(FootSelectorTest, standsBetweenBallAndOpponentWhereItDoesNotMatterOtherwise) {
  harness.input<OtherRobots>().robots.resize(1);
  OtherRobot& opponent = harness.input<OtherRobots>().robots[0];
  opponent.position = {0.1, -0.5};
  EXPECT_EQ(footFrom({-1, 0}), Side::left);
  opponent.position = {0.1, 0.5};
  EXPECT_EQ(footFrom({-1, 0}), Side::right);
  EXPECT_EQ(footFrom({-1, -0.2}), Side::left);
  opponent.mate = true;
  EXPECT_EQ(footFrom({-1, 0}), Side::left) << "a mate changes nothing";
}

}  // namespace
