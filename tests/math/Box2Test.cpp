#include "math/Box2.h"

#include <gtest/gtest.h>

using namespace plumbline;

namespace {

TEST(Box2Test, saysWhichPlacesAndWaysItHolds) {
  const Box2 box{{1, -1}, {3, 2}};
  EXPECT_TRUE(box.contains({2, 0}));
  EXPECT_FALSE(box.contains({3.1, 0}));
  EXPECT_TRUE(box.meets({0, 0}, {5, 0}));
  EXPECT_TRUE(box.meets({2, 0}, {5, 0})) << "out of it";
  EXPECT_TRUE(box.meets({2, 5}, {2, -5})) << "along an axis";
  EXPECT_FALSE(box.meets({0, 0}, {0.9, 0})) << "ends before it";
  EXPECT_FALSE(box.meets({0, 3}, {5, 3}));
  EXPECT_FALSE(box.meets({0, 1}, {2, 4})) << "past the corner";
  EXPECT_FALSE(box.meets({3, -5}, {3, 5})) << "along the border";
}

}  // namespace
