#include "robot/WalkLimits.h"

#include <gtest/gtest.h>

namespace plumbline {
namespace {

TEST(WalkLimits, areKnownWhereAllSpeedsAre) {
  EXPECT_FALSE(WalkLimits().known());
  EXPECT_FALSE((WalkLimits{.forward = 0.5, .backward = 0.3, .turn = 1}.known())) << "nothing to the side";
  EXPECT_TRUE((WalkLimits{.forward = 0.5, .backward = 0.3, .sideways = 0.2, .turn = 1}.known()));
}

}  // namespace
}  // namespace plumbline
