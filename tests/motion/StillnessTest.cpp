#include "motion/Stillness.h"

#include <gtest/gtest.h>

namespace plumbline::motion {
namespace {

TEST(Stillness, aTorsoIsStillInTheThirdCycleWithoutATurn) {
  Stillness stillness;
  const Vec3 calm(0.1, -0.2, 0.1);
  EXPECT_FALSE(stillness.update(calm));
  EXPECT_FALSE(stillness.update(calm));
  EXPECT_TRUE(stillness.update(calm));
  EXPECT_TRUE(stillness.still());
}

TEST(Stillness, oneTurnAndItBeginsAnew) {
  Stillness stillness;
  for (int i = 0; i < 5; ++i) stillness.update(Vec3::Zero());
  EXPECT_FALSE(stillness.update(Vec3(0, 0.31, 0)));
  EXPECT_FALSE(stillness.update(Vec3::Zero()));
  EXPECT_FALSE(stillness.update(Vec3::Zero()));
  EXPECT_TRUE(stillness.update(Vec3::Zero()));
}

}  // namespace
}  // namespace plumbline::motion
