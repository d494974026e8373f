#include <gtest/gtest.h>

#include "modules/skills/SkillCombinator.h"
#include "modules/skills/SkillDive.h"
#include "modules/skills/SkillDribble.h"
#include "modules/skills/SkillGetBall.h"
#include "modules/skills/SkillKick.h"
#include "modules/skills/SkillMoveToPos.h"
#include "representations/skills/SkillDribbleOutput.h"
#include "representations/skills/SkillKickOutput.h"
#include "support/ModuleHarness.h"

using namespace plumbline;

namespace {

void request(SkillRequest& request, const char* skill, const Pose2& target) {
  request.skill = skill;
  request.target = target;
}

TEST(SkillMoveToPos, walksThereAndStands) {
  test::ModuleHarness<SkillMoveToPos> harness;
  request(harness.input<SkillRequest>(), Skill::moveToPos, Pose2(2, 1, 0.5));
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

TEST(SkillDive, goesToTheSideOfItsTarget) {
  test::ModuleHarness<SkillDive> harness;
  harness.input<RobotPose>().pose = Pose2(-14, 0, 1.5);
  request(harness.input<SkillRequest>(), Skill::dive, Pose2(-14.5, 0.1, 0));
  harness.cycle();
  const SkillOutput& output = harness.output<SkillDiveOutput>();
  EXPECT_TRUE(output.active);
  EXPECT_EQ(output.motion, Motion::specialAction);
  EXPECT_EQ(output.specialAction, "diveLeft");
  EXPECT_TRUE(output.atOnce);
  request(harness.input<SkillRequest>(), Skill::dive, Pose2(-13.5, 0.1, 0));
  harness.cycle();
  EXPECT_EQ(output.specialAction, "diveRight");
  harness.input<SkillRequest>().skill = Skill::moveToPos;
  harness.cycle();
  EXPECT_FALSE(output.active);
}

TEST(SkillMoveToPos, isInactiveForOtherSkills) {
  test::ModuleHarness<SkillMoveToPos> harness;
  harness.input<SkillRequest>().skill = Skill::kick;
  harness.input<RobotPose>();
  harness.cycle();
  EXPECT_FALSE(harness.output<SkillMoveToPosOutput>().active);
}

struct GetBallTest : testing::Test {
  GetBallTest() {
    harness.input<FrameInfo>().cycleSeconds = 0.02;
    SkillKickParameters& kick = harness.input<SkillKickParameters>();
    kick.kicks = {Kick()};
    kick.kicks[0].motion = "kickRight";
    kick.kicks[0].ballPosition = {0.16, -0.05};
    harness.input<ActiveFoot>();
    harness.input<SkillKickOutput>();  // how a skill wants to stand at the ball, its output says
  }
  /// How exactly it has to stand and how it learns a drift, instead of what the configuration says; after the
  /// inputs were named.
  void setTolerances(double heading = 0.15) {
    BallPositioningParameters& p = harness.module().positioning;
    p.toleranceForward = p.toleranceSideways = 0.03;
    p.toleranceHeading = heading;
    p.keeps = 1.4;
    p.biasGain = 1.5;
    p.biasDistance = p.maxBias = 0.15;
  }
  // The robot at the origin looks along x, the ball lies here, and shall go along x.
  const SkillGetBallOutput& ballAt(const Vec2& ball, const char* skill = Skill::kick) {
    request(harness.input<SkillRequest>(), skill, Pose2(10, ball.y(), 0));
    harness.input<RobotPose>().pose = Pose2();
    harness.input<BallPos>().relative = ball;
    harness.input<BallPos>().field = ball;
    setTolerances();
    harness.cycle();
    return harness.output<SkillGetBallOutput>();
  }
  test::ModuleHarness<SkillGetBall> harness;
};

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
    request(harness.input<SkillRequest>(), Skill::kick, Pose2(metres + 0.5, 0, 0));
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
  EXPECT_TRUE(output.atOnce) << "not in a duel";
  harness.input<SkillRequest>().skill = Skill::dribble;
  harness.cycle();
  EXPECT_FALSE(output.active);
}

struct DribbleTest : testing::Test {
  DribbleTest() {
    SkillOutput& approach = harness.input<SkillGetBallOutput>();
    approach.motion = Motion::walk;
    approach.walkVelocity = {-0.123, 0};
  }
  // The robot at the origin looks along x; the ball lies here and shall go to this direction.
  const SkillOutput& ballAt(const Vec2& ball, double direction = 0) {
    request(harness.input<SkillRequest>(), Skill::dribble,
            Pose2(Vec2(ball + 10 * Vec2(std::cos(direction), std::sin(direction))), 0));
    harness.input<RobotPose>().pose = Pose2();
    harness.input<BallPos>().relative = ball;
    harness.input<BallPos>().field = ball;
    harness.cycle();
    return harness.output<SkillDribbleOutput>();
  }
  bool pushes(const Vec2& ball, double direction = 0) {
    return ballAt(ball, direction).walkVelocity.x() != -0.123;
  }
  test::ModuleHarness<SkillDribble> harness;
};

TEST_F(DribbleTest, getsBehindTheBallFirst) {
  EXPECT_FALSE(pushes({0.2, 0.3}));
  EXPECT_FALSE(pushes({-0.2, 0}));
  EXPECT_FALSE(pushes({0.2, 0}, 1.0));
}

TEST_F(DribbleTest, pushesStraightAheadAndStaysBehindTheBall) {
  const SkillOutput& output = ballAt({0.2, 0.03});
  EXPECT_TRUE(output.active);
  EXPECT_GT(output.walkVelocity.x(), 0.2);
  EXPECT_GT(output.walkVelocity.y(), 0);  // to the side on which the ball lies
}

TEST_F(DribbleTest, breaksOffLaterThanItBegins) {
  EXPECT_FALSE(pushes({0.2, 0.1}));
  EXPECT_TRUE(pushes({0.2, 0}));
  EXPECT_TRUE(pushes({0.2, 0.1}));
  EXPECT_FALSE(pushes({0.2, 0.2}));
}

TEST_F(DribbleTest, pushesAtOnceWhereAnOpponentIsNear) {
  EXPECT_FALSE(pushes({0.2, 0.1})) << "nobody is near";
  harness.input<SkillGetBallOutput>().pressed = true;
  EXPECT_TRUE(pushes({0.2, 0.1}));
}

TEST_F(DribbleTest, goesStraightToTheBallInADuel) {
  harness.input<SkillGetBallOutput>().pressed = true;
  // The ball lies 0.2 m to the left and shall go straight on: sideways, to a place 0.13 m behind it.
  const SkillOutput& output = ballAt({0.2, 0.2});
  EXPECT_GT(output.walkVelocity.y(), 0.2);
  EXPECT_NEAR(output.walkVelocity.x() / output.walkVelocity.y(), 0.07 / 0.2, 1e-9);
  EXPECT_EQ(output.walkTurn, 0);
  // To the left: it turns on the way.
  EXPECT_GT(ballAt({0.4, 0}, 1.0).walkTurn, 0.5);
  EXPECT_FALSE(pushes({-0.2, 0.1})) << "the ball is behind it";
  EXPECT_FALSE(pushes({1.5, 0.3})) << "far away";
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
  SkillOutput& dribble = harness.input<SkillDribbleOutput>();
  dribble.active = true;
  dribble.motion = Motion::walk;
  dribble.walkVelocity = {1, 0};
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

}  // namespace
