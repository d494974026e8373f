#include "walking/planning/SwingTrajectory.h"

#include <gtest/gtest.h>

namespace plumbline::walking {
namespace {

TEST(SwingTrajectory, goesFromGroundToGround) {
  const SwingTrajectory swing{.start = 0.1, .end = 0.9};
  const Pose2 from(-0.1, -0.11, 0.1), to(0.1, -0.12, -0.2);
  EXPECT_EQ(swing.between(from, to, 0.1).position, from.position);
  EXPECT_NEAR((swing.between(from, to, 0.9).position - to.position).norm(), 0, 1e-12);
  EXPECT_NEAR(swing.between(from, to, 1).heading, -0.2, 1e-12);
  EXPECT_NEAR(swing.between(from, to, 0.5).x(), 0, 1e-12);
  EXPECT_DOUBLE_EQ(swing.lift(0), 0);
  EXPECT_NEAR(swing.lift(1), 0, 1e-12);
  EXPECT_DOUBLE_EQ(swing.lift(0.5), 1);
}

TEST(SwingTrajectory, neverGoesBack) {
  for (const double smoothness : {0.0, 0.5, 1.0}) {
    const SwingTrajectory swing{.start = 0.2, .smoothness = smoothness};
    double last = -1e-12;
    for (int i = 0; i <= 100; ++i) {
      const double share = swing.share(i / 100.0);
      EXPECT_GE(share, last);
      last = share;
    }
    EXPECT_DOUBLE_EQ(last, 1);
  }
}

}  // namespace
}  // namespace plumbline::walking
