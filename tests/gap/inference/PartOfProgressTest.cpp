#include "gap/inference/PartOfProgress.h"

#include <gtest/gtest.h>

namespace plumbline::gap {

TEST(PartOfProgress, aPartIsReportedAsWhatItIsOfTheWhole) {
  double at = 0;
  const std::function<void(double)> whole = [&](double share) { at = share; };
  const auto part = partOf(whole, 0.5, 0.75);
  part(0);
  EXPECT_DOUBLE_EQ(at, 0.5);
  part(0.4);
  EXPECT_DOUBLE_EQ(at, 0.6);
}

TEST(PartOfProgress, whereNobodyListensNothingIsReported) { EXPECT_FALSE(partOf({}, 0, 1)); }

}  // namespace plumbline::gap
