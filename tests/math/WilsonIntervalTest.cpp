#include "math/WilsonInterval.h"

#include <gtest/gtest.h>

namespace plumbline {
namespace {

TEST(WilsonInterval, ofTenInAHundred) {
  // (0.1 + 3.84 / 200) / (1 + 3.84 / 100), less and more 0.0596.
  EXPECT_NEAR(wilsonInterval(10, 100).first, 0.0552, 1e-4);
  EXPECT_NEAR(wilsonInterval(10, 100).second, 0.1744, 1e-4);
}

TEST(WilsonInterval, endsAtTheEndsOfARate) {
  EXPECT_EQ(wilsonInterval(0, 5).first, 0);
  EXPECT_NEAR(wilsonInterval(0, 5).second, 0.4345, 1e-4);
  EXPECT_NEAR(wilsonInterval(5, 5).first, 0.5655, 1e-4);
  EXPECT_EQ(wilsonInterval(5, 5).second, 1);
  EXPECT_EQ(wilsonInterval(0, 0), (std::pair<double, double>(0, 1)));
}

}  // namespace
}  // namespace plumbline
