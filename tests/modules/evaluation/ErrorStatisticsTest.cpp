#include "modules/evaluation/ErrorStatistics.h"

#include <gtest/gtest.h>

#include <limits>

using namespace plumbline;

namespace {

TEST(ErrorStatistics, quantilesOfWhatWasAdded) {
  ErrorStatistics errors;
  EXPECT_EQ(errors.quantile(0.5), 0);
  for (int i = 100; i >= 0; --i) errors.add(i);
  errors.add(std::numeric_limits<double>::quiet_NaN());
  EXPECT_EQ(errors.count(), 101u);
  EXPECT_EQ(errors.quantile(0.5), 50);
  EXPECT_EQ(errors.quantile(0.95), 95);
  EXPECT_EQ(errors.quantile(0), 0);
  EXPECT_EQ(errors.largest(), 100);
}

TEST(ErrorStatistics, memoryIsBounded) {
  ErrorStatistics errors;
  const std::size_t n = 10 * ErrorStatistics::maxSamples;
  for (std::size_t i = 0; i < n; ++i) errors.add(static_cast<double>(i % 1000));
  EXPECT_EQ(errors.count(), n);
  EXPECT_NEAR(errors.quantile(0.5), 500, 10);
  EXPECT_NEAR(errors.quantile(0.95), 950, 10);
}

}  // namespace
