#include "modules/skills/SkillGetBall.h"

#include <gtest/gtest.h>

#include "modules/skills/GetBallFixture.h"

using namespace plumbline;
using plumbline::test::GetBallTest;

namespace {

TEST_F(GetBallTest, isAtTheBallOnlyWithinTheTolerance) {
  EXPECT_TRUE(ballAt({0.16, -0.05}).atBall);
  EXPECT_EQ(ballAt({0.16, -0.05}).kickFoot, Side::right);
  EXPECT_TRUE(ballAt({0.18, -0.07}).atBall);
  EXPECT_FALSE(ballAt({0.21, -0.05}).atBall);
  EXPECT_FALSE(ballAt({0.20, -0.05}).atBall);
  EXPECT_FALSE(ballAt({0.16, -0.09}).atBall);
}

TEST_F(GetBallTest, staysAtTheBallWhileItStopsForTheKick) {
  EXPECT_FALSE(ballAt({0.20, -0.05}).atBall);
  EXPECT_TRUE(ballAt({0.16, -0.05}).atBall);
  EXPECT_TRUE(ballAt({0.20, -0.05}).atBall) << "within 1.4 tolerances";
  EXPECT_FALSE(ballAt({0.21, -0.05}).atBall);
  EXPECT_FALSE(ballAt({0.20, -0.05}).atBall);
}

TEST_F(GetBallTest, anOpponentNearTheBallLeavesNoTimeToStandExactly) {
  harness.input<OtherRobots>().robots.resize(2);
  OtherRobot& opponent = harness.input<OtherRobots>().robots[0];
  OtherRobot& mate = harness.input<OtherRobots>().robots[1];
  opponent.position = {1.1, 0};
  mate.mate = true;
  mate.position = {0.3, 0};
  EXPECT_FALSE(ballAt({0.205, -0.05}).pressed);
  EXPECT_FALSE(ballAt({0.205, -0.05}).atBall) << "45 mm off";
  opponent.position = {0.9, 0};
  EXPECT_TRUE(ballAt({0.205, -0.05}).pressed);
  EXPECT_TRUE(ballAt({0.205, -0.05}).atBall);
  opponent.fallen = true;
  EXPECT_FALSE(ballAt({0.205, -0.05}).pressed);
}

TEST_F(GetBallTest, anOpponentNearTheBallLeavesNoTimeToTurnExactly) {
  OtherRobot& opponent = harness.input<OtherRobots>().robots.emplace_back();
  const auto turnedOff = [&](double off) {
    ballAt({0.5, -0.05});  // away, so that nothing stays
    harness.input<BallPos>().relative = harness.input<BallPos>().field = Vec2(0.16, -0.05);
    harness.input<SkillRequest>().target = Pose2(10.16, -0.05 + 10 * std::tan(off));
    harness.cycle();
    return harness.output<SkillGetBallOutput>().atBall;
  };
  opponent.position = {3, 0};
  EXPECT_TRUE(turnedOff(0.1));
  EXPECT_FALSE(turnedOff(0.25));
  opponent.position = {0.8, 0};
  EXPECT_TRUE(turnedOff(0.25));
  EXPECT_FALSE(turnedOff(0.4));
}

TEST_F(GetBallTest, aRequestMaySayHowExactlyTheBallHasToGo) {
  ballAt({0.16, -0.05});
  SkillRequest& wanted = harness.input<SkillRequest>();
  const auto turnedBy = [&](double heading) {
    harness.input<RobotPose>().pose = Pose2(Vec2(5, 0), 0);  // away, so that nothing stays
    harness.input<BallPos>().relative = Vec2(1, 0);
    harness.cycle();
    harness.input<RobotPose>().pose = Pose2(Vec2::Zero(), heading);
    harness.input<BallPos>().relative = Vec2(0.16, -0.05);
    harness.input<BallPos>().field = Eigen::Rotation2Dd(heading) * Vec2(0.16, -0.05);
    wanted.target = Pose2(Vec2(harness.input<BallPos>().field + Vec2(10, 0)), 0);
    harness.cycle();
    return harness.output<SkillGetBallOutput>().atBall;
  };
  EXPECT_TRUE(turnedBy(0.1));
  EXPECT_FALSE(turnedBy(0.3));
  wanted.tolerance = 0.06;
  EXPECT_FALSE(turnedBy(0.1));
  wanted.tolerance = 0.35;
  EXPECT_TRUE(turnedBy(0.3));
}

TEST_F(GetBallTest, kicksWithTheFootThatWasChosen) {
  EXPECT_FALSE(ballAt({0.16, 0.05}).atBall);
  EXPECT_EQ(ballAt({0.16, -0.05}).kickFoot, Side::right);
  harness.input<ActiveFoot>().foot = Side::left;
  EXPECT_TRUE(ballAt({0.16, 0.05}).atBall);
  EXPECT_EQ(ballAt({0.16, 0.05}).kickFoot, Side::left);
  EXPECT_FALSE(ballAt({0.16, -0.05}).atBall);
}

TEST_F(GetBallTest, walksTowardsTheBall) {
  EXPECT_GT(ballAt({2, 0}).walkVelocity.x(), 0.3);
  EXPECT_GT(ballAt({0, 2}).walkTurn, 0.5);
}

TEST_F(GetBallTest, aRobotThatComesToRestShortOfTheBallAsksForMore) {
  const double first = ballAt({0.21, -0.05}).walkVelocity.x();
  for (int i = 0; i < 50; ++i) ballAt({0.21, -0.05});
  // 5 cm short for a second: 1.5 / s^2 * 0.05 m * 1 s more.
  EXPECT_NEAR(ballAt({0.21, -0.05}).walkVelocity.x() - first, 1.5 * 0.05 * 51 * 0.02, 1e-9);
  // Far away nothing of it is left.
  ballAt({2, 0});
  EXPECT_NEAR(ballAt({0.21, -0.05}).walkVelocity.x(), first, 1e-9);
}

TEST_F(GetBallTest, isActiveByItselfOnlyForGetBall) {
  EXPECT_FALSE(ballAt({1, 0}, Skill::kick).active);
  EXPECT_TRUE(ballAt({1, 0}, Skill::getBall).active);
}

/// A skill that no file of the project names.
REPRESENTATION_OF(SkillPassOutput, SkillOutput)
class SkillPassOutput : public SkillPassOutputBase {
public:
  SkillPassOutput() : SkillPassOutputBase("pass", "passing", BallApproach::dribble) {}
};

TEST_F(GetBallTest, standsAtTheBallAsANewSkillWants) {
  harness.input<SkillPassOutput>();
  EXPECT_TRUE(ballAt({0.2, 0}, "pass").atBall) << "the ball ahead, as before a dribble";
  EXPECT_FALSE(ballAt({0.16, -0.05}, "pass").atBall);
  EXPECT_FALSE(ballAt({0.2, 0}, "juggle").atBall) << "nobody provides that skill";
}

}  // namespace
