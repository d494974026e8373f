// Which of its kicks SkillGetBall chooses, and how it stands for it.
#include <gtest/gtest.h>

#include "modules/skills/GetBallFixture.h"

using namespace plumbline;
using plumbline::test::GetBallTest;

namespace {

/// Three kicks: 3, 6 and 12 m; the middle one goes 0.1 rad to the left.
struct KicksTest : GetBallTest {
  KicksTest() {
    SkillKickParameters& parameters = harness.input<SkillKickParameters>();
    parameters.kicks.resize(3);
    const char* names[] = {"short", "middle", "long"};
    for (std::size_t i = 0; i < 3; ++i) parameters.kicks[i].motion = names[i];
    parameters.kicks[0].distance = 3;
    parameters.kicks[1].distance = 6;
    parameters.kicks[1].direction = 0.1;
    parameters.kicks[1].ballPosition = {0.20, -0.04};
    parameters.kicks[2].distance = 12;
  }
  std::string kickOver(double metres) {
    test::wish(harness, Skill::kick, Pose2(metres + 0.5, 0, 0));
    harness.input<RobotPose>().pose = Pose2();
    harness.input<BallPos>().relative = harness.input<BallPos>().field = Vec2(0.5, 0);
    harness.cycle();
    return harness.output<SkillGetBallOutput>().kick;
  }
};

TEST_F(KicksTest, takesTheShortestThatCarriesFarEnoughElseTheLongest) {
  EXPECT_EQ(kickOver(2), "short");
  EXPECT_EQ(kickOver(5), "middle");
  EXPECT_EQ(kickOver(9), "long");
  EXPECT_EQ(kickOver(25), "long");
}

TEST_F(KicksTest, isReluctantToChangeTheKick) {
  EXPECT_EQ(kickOver(2.9), "short");
  EXPECT_EQ(kickOver(3.2), "short") << "within kickMargin, 0.3 m";
  EXPECT_EQ(kickOver(3.4), "middle");
  EXPECT_EQ(kickOver(2.8), "middle");
  EXPECT_EQ(kickOver(2.6), "short");
}

TEST_F(KicksTest, standsWhereTheKickWantsTheBallAndTurnedByItsDirection) {
  kickOver(5);
  harness.input<SkillRequest>().target = Pose2(5, -0.04, 0);
  BallPos& ball = harness.input<BallPos>();
  ball.relative = ball.field = Vec2(0.20, -0.04);
  setTolerances(0.01);
  harness.cycle();
  EXPECT_FALSE(harness.output<SkillGetBallOutput>().atBall) << "it would kick 0.1 rad to the left";
  // The robot turned to the right by as much, the ball at the same place relative to it.
  harness.input<RobotPose>().pose = Pose2(Vec2::Zero(), -0.1);
  harness.cycle();
  EXPECT_TRUE(harness.output<SkillGetBallOutput>().atBall);
  // With the left foot all is mirrored.
  harness.input<ActiveFoot>().foot = Side::left;
  ball.relative = Vec2(0.20, 0.04);
  harness.cycle();
  EXPECT_FALSE(harness.output<SkillGetBallOutput>().atBall);
  harness.input<RobotPose>().pose = Pose2(Vec2::Zero(), 0.1);
  harness.cycle();
  EXPECT_TRUE(harness.output<SkillGetBallOutput>().atBall);
  EXPECT_EQ(harness.output<SkillGetBallOutput>().kickFoot, Side::left);
}

}  // namespace
