#include "walking/planning/SpeedLimits.h"

#include <gtest/gtest.h>

namespace plumbline::walking {
namespace {

TEST(SpeedLimits, withoutALimitOfMixturesThatOfOneDirectionCounts) {
  WalkParameters p;
  p.speed.omniForward = 0;
  p.speed.omniBackward = 0.7;
  p.speed.omniSideways = 0.2;
  p.speed.omniTurn = 0;
  p.speed.maxForward = 0.5;
  p.speed.maxBackward = 0.4;
  p.speed.maxSideways = 0.25;
  p.speed.maxTurn = 1.6;
  const WalkLimits found = walkLimits(p);
  EXPECT_EQ(found.forward, 0.5);
  EXPECT_EQ(found.backward, 0.4);
  EXPECT_EQ(found.sideways, 0.2);
  EXPECT_EQ(found.turn, 1.6);
  EXPECT_TRUE(found.known());
}

}  // namespace
}  // namespace plumbline::walking
