#include "modules/skills/SkillDribble.h"

#include <gtest/gtest.h>

#include <cmath>

#include "modules/skills/SkillWish.h"

using namespace plumbline;

namespace {

struct DribbleTest : testing::Test {
  DribbleTest() {
    SkillOutput& approach = harness.input<SkillGetBallOutput>();
    approach.motion = Motion::walk;
    approach.walkVelocity = {-0.123, 0};
  }
  // The robot at the origin looks along x; the ball lies here and shall go to this direction.
  const SkillOutput& ballAt(const Vec2& ball, double direction = 0) {
    test::wish(harness, Skill::dribble,
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

}  // namespace
