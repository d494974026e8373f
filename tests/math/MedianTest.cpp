#include "math/Median.h"

#include <gtest/gtest.h>

namespace plumbline {
namespace {

TEST(Median, isTheMiddleValueOrTheLargerOfTwo) {
  EXPECT_EQ(upperMedian({3, 1, 2}), 2);
  EXPECT_EQ(upperMedian({4, 1, 3, 2}), 3);
  EXPECT_EQ(upperMedian({5}), 5);
}

TEST(Median, saysWhatItIsOfNoValues) {
  EXPECT_EQ(upperMedian({}), 0);
  EXPECT_EQ(upperMedian({}, -1), -1);
}

}  // namespace
}  // namespace plumbline
