#include "walking/planning/KickRequest.h"

#include <gtest/gtest.h>

namespace plumbline::walking {
namespace {

TEST(KickRequestTest, theFootFirstCarriesAStepAndKicksInTheNext) {
  KickRequest kick{.foot = Side::left};
  kick.beginStep(Side::right);  // the left foot swings, but no step led to it
  EXPECT_FALSE(kick.prepared);
  EXPECT_FALSE(kick.now);
  kick.beginStep(Side::left);
  EXPECT_TRUE(kick.prepared);
  EXPECT_FALSE(kick.now);
  kick.beginStep(Side::right);
  EXPECT_TRUE(kick.now);
  EXPECT_FALSE(kick.done);
  kick.beginStep(Side::left);
  EXPECT_FALSE(kick.now);
  EXPECT_FALSE(kick.foot);
  EXPECT_TRUE(kick.done);
}

TEST(KickRequestTest, nothingIsKickedWhereNothingIsAskedFor) {
  KickRequest kick;
  for (const Side side : {Side::left, Side::right, Side::left}) kick.beginStep(side);
  EXPECT_FALSE(kick.prepared || kick.now || kick.done);
}

}  // namespace
}  // namespace plumbline::walking
