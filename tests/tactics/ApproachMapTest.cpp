#include "tactics/ApproachMap.h"

#include <gtest/gtest.h>

using namespace plumbline;

namespace {

const WalkSpeeds walk{.forward = 0.6, .backward = 0.4, .sideways = 0.3, .turn = 1.8};
const Vec2 ahead(0.17, -0.05);

const ApproachMap& map() {
  static const ApproachMap made(walk, ahead, {});
  return made;
}

TEST(ApproachMap, straightWaysTakeAsLongAsTheWalkNeeds) {
  EXPECT_EQ(map().seconds(Pose2()), 0);
  EXPECT_NEAR(map().seconds(Pose2(-0.3, 0, 0)), 0.3 / 0.6, 0.02);
  EXPECT_NEAR(map().seconds(Pose2(-1.2, 0, 0)), 1.2 / 0.6, 0.05);
  EXPECT_NEAR(map().seconds(Pose2(0, -0.3, 0)), 0.3 / 0.3, 0.05) << "sideways";
  EXPECT_NEAR(map().seconds(Pose2(0, 0, -0.6)), 0.6 / 1.8, 0.05) << "turning";
}

TEST(ApproachMap, theWayRoundTheBallTakesLonger) {
  // From 1 m before the ball, facing it: a half circle, and half a turn at least.
  const double before = map().seconds(Pose2(1.17, -0.05, pi));
  const double behind = map().seconds(Pose2(-0.83, -0.05, 0));
  const double beside = map().seconds(Pose2(0.17, 0.95, -pi / 2));
  EXPECT_GT(before, 1 / 0.6 + pi / 1.8);
  EXPECT_LT(before, 6);
  EXPECT_GT(beside, behind + 1);
  EXPECT_GT(before, beside);
  // The straight way backward from close before the ball would go over it.
  EXPECT_GT(map().seconds(Pose2(0.4, 0, 0)), 0.4 / 0.4 + 1);
}

TEST(ApproachMap, headingAwayCostsTheTurn) {
  const double towards = map().seconds(Pose2(-1, 0, 0)), away = map().seconds(Pose2(-1, 0, pi));
  EXPECT_GT(away, towards + 0.8);
  EXPECT_LT(away, towards + pi / 1.8 + 0.1);
}

TEST(ApproachMap, knowsWhatTouchesTheBall) {
  EXPECT_FALSE(map().touches(Pose2()));
  EXPECT_TRUE(map().touches(Pose2(0.1, 0, 0))) << "before it";
  EXPECT_TRUE(map().touches(Pose2(0.17, 0.1, 0))) << "beside it";
  EXPECT_FALSE(map().touches(Pose2(0.17, 0.3, 0)));
}

TEST(ApproachMap, goesOnBeyondItsBorder) {
  for (const double angle : {0.0, 1.0, 2.0, 3.0, 4.0, 5.0}) {
    const Vec2 out(std::cos(angle), std::sin(angle));
    const double border = 1.6 / out.cwiseAbs().maxCoeff();
    const double course = std::atan2(-out.y(), -out.x());
    const double inside = map().seconds(Pose2(Vec2(0.999 * border * out), course));
    EXPECT_NEAR(map().seconds(Pose2(Vec2(1.001 * border * out), course)), inside, 0.02) << angle;
    EXPECT_NEAR(map().seconds(Pose2(Vec2((border + 4) * out), course)), inside + 4 / 0.8, 0.02) << angle;
  }
}

TEST(ApproachMap, aFasterWalkIsSooner) {
  WalkSpeeds faster = walk;
  faster.forward = 0.9;
  const ApproachMap other(faster, ahead, {});
  for (double angle = 0; angle < 2 * pi; angle += 0.5) {
    const Pose2 robot(Vec2(std::cos(angle), std::sin(angle)), 2 * angle);
    EXPECT_LE(other.seconds(robot), map().seconds(robot) + 0.02) << angle;
  }
}

}  // namespace
