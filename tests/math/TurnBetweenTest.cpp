#include "math/TurnBetween.h"

#include <gtest/gtest.h>

#include "math/Angle.h"

namespace plumbline {

TEST(TurnBetween, takesOneDirectionToTheOther) {
  const Vec3 from = Vec3(1, 2, -0.5).normalized(), to = Vec3(-0.3, 1, 2).normalized();
  const Vec3 turn = turnBetween(from, to);
  EXPECT_LT((rotation(turn.normalized(), turn.norm()) * from - to).norm(), 1e-15);
  EXPECT_NEAR(turn.norm(), std::acos(from.dot(to)), 1e-15);
}

TEST(TurnBetween, isZeroBetweenADirectionAndItself) {
  EXPECT_EQ(turnBetween(Vec3::UnitZ(), Vec3::UnitZ()), Vec3(Vec3::Zero()));
}

TEST(TurnBetween, turnsAboutSomeAxisAcrossToTheOpposite) {
  const Vec3 turn = turnBetween(Vec3::UnitZ(), -Vec3::UnitZ());
  EXPECT_NEAR(turn.norm(), pi, 1e-15);
  EXPECT_EQ(turn.z(), 0);
}

}  // namespace plumbline
