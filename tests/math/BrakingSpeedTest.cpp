#include "math/BrakingSpeed.h"

#include <gtest/gtest.h>

namespace plumbline {
namespace {

TEST(BrakingSpeed, stepsOfThatTimeEndAtTheDistance) {
  const double time = 0.2, deceleration = 0.8;
  double left = 0.5, speed = brakingSpeed(left, deceleration, time);
  for (; speed > 0; speed -= deceleration * time) left -= speed * time;
  EXPECT_NEAR(left, 0, 0.02);
  EXPECT_EQ(brakingSpeed(0, deceleration, time), 0);
}

}  // namespace
}  // namespace plumbline
