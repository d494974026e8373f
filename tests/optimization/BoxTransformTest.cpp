#include "optimization/BoxTransform.h"

#include <gtest/gtest.h>

#include <limits>

namespace plumbline {
namespace {

using Eigen::VectorXd;
constexpr double infinity = std::numeric_limits<double>::infinity();

BoxTransform make(double lower, double upper) {
  return {VectorXd::Constant(1, lower), VectorXd::Constant(1, upper)};
}

TEST(BoxTransform, identityInsideNeverOutside) {
  const BoxTransform box = make(-2, 6);
  EXPECT_EQ(box.toBox(0, 1.5), 1.5);
  for (double x = -100; x < 100; x += 0.0137) {
    EXPECT_GE(box.toBox(0, x), -2);
    EXPECT_LE(box.toBox(0, x), 6);
  }
  EXPECT_EQ(box.toBox(0, -2 - 0.15), -2);  // the margin is (1 + 2) / 20
  EXPECT_NEAR(box.toBox(0, 6.35 + 1), box.toBox(0, 6.35 - 1), 1e-12);
}

TEST(BoxTransform, continuousAndTurnedRound) {
  const BoxTransform box = make(-2, 6);
  for (double x = -3; x < 7; x += 1e-3)
    EXPECT_LT(std::abs(box.toBox(0, x + 1e-3) - box.toBox(0, x)), 1.001e-3) << x;
  for (double y = -2; y <= 6; y += 0.01) {
    EXPECT_NEAR(box.toBox(0, box.fromBox(0, y)), y, 1e-12);
    EXPECT_GE(box.fromBox(0, y), -2.15 - 1e-12) << "the nearest of all that come to it";
    EXPECT_LE(box.fromBox(0, y), 6.35 + 1e-12);
  }
}

TEST(BoxTransform, oneBoundOrNone) {
  const BoxTransform half = make(0, infinity);
  EXPECT_EQ(half.toBox(0, 1e6), 1e6);
  EXPECT_GE(half.toBox(0, -1e6), 0);
  EXPECT_NEAR(half.toBox(0, half.fromBox(0, 1e-5)), 1e-5, 1e-15);
  const BoxTransform below = make(-infinity, 0);
  EXPECT_EQ(below.toBox(0, -1e6), -1e6);
  EXPECT_LE(below.toBox(0, 1e6), 0);
  const BoxTransform none = make(-infinity, infinity);
  EXPECT_EQ(none.toBox(0, -1e9), -1e9);
}

}  // namespace
}  // namespace plumbline
