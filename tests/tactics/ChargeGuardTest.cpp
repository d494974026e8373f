#include "tactics/ChargeGuard.h"

#include <gtest/gtest.h>

using namespace plumbline;

namespace {

struct ChargeGuardTest : testing::Test {
  Vec2 allowed(const Vec2& velocity, const Vec2& ball, const std::vector<Vec2>& opponents) {
    return guard.allowed(velocity, ball, opponents, {}, 0.02);
  }
  ChargeGuard guard;
};

TEST_F(ChargeGuardTest, slowsDownBeforeAnOpponentThatHasTheBall) {
  // 0.2 m to the contact in half a second.
  EXPECT_LT((allowed({1, 0}, {0.8, 0}, {{0.5, 0}}) - Vec2(0.4, 0)).norm(), 1e-12);
  EXPECT_LT((allowed({1, 0}, {0.8, 0}, {{0.32, 0}}) - Vec2(0.1, 0)).norm(), 1e-12);
  EXPECT_EQ(allowed({1, 0}, {1.8, 0}, {{1.5, 0}}), Vec2(1, 0)) << "far enough away";
}

TEST_F(ChargeGuardTest, leavesTheWayAside) {
  // Of a way 45 degrees beside the opponent the part towards it is slower.
  const Vec2 slower = allowed({0.5, 0.5}, {0.8, 0}, {{0.4, 0}});
  EXPECT_LT((slower - Vec2(0.2, 0.5)).norm(), 1e-12);
  EXPECT_EQ(allowed({0, 0.5}, {0.8, 0}, {{0.4, 0}}), Vec2(0, 0.5));
  EXPECT_EQ(allowed({-0.5, 0}, {0.8, 0}, {{0.4, 0}}), Vec2(-0.5, 0)) << "away from it";
}

TEST_F(ChargeGuardTest, isNotForTheRobotThatIsNearerToTheBall) {
  EXPECT_EQ(allowed({1, 0}, {0.3, 0}, {{0.6, 0}}), Vec2(1, 0));
  EXPECT_LT(allowed({1, 0}, {0.3, 0}, {{0.5, 0}}).x(), 1) << "the opponent is nearer by 0.1 m";
}

TEST_F(ChargeGuardTest, whoHasJustTouchedTheBallMayGoOn) {
  allowed({1, 0}, {0.12, 0}, {{0.4, 0}});
  for (int i = 0; i < 34; ++i) EXPECT_EQ(allowed({1, 0}, {0.5, 0}, {{0.4, 0}}), Vec2(1, 0));
  allowed({1, 0}, {0.5, 0}, {{0.4, 0}});
  EXPECT_LT(allowed({1, 0}, {0.5, 0}, {{0.4, 0}}).x(), 0.5) << "0.7 s later";
}

}  // namespace
