#include "walking/estimation/WalkOdometry.h"

#include <gtest/gtest.h>

namespace plumbline::walking {
namespace {

TEST(WalkOdometry, tellsWhatIsCommandedWhenItCanBeMeasured) {
  WalkParameters p;
  p.odometry.delay = 0.04;
  p.odometry.scaleForward = 1.1;
  WalkOdometry odometry;
  odometry.reset({});
  const Pose2 step(0.01, 0);
  EXPECT_EQ(odometry.update(step, {}, false, p, 0.02).x(), 0);
  EXPECT_EQ(odometry.update(step, {}, false, p, 0.02).x(), 0);
  EXPECT_NEAR(odometry.update(step, {}, false, p, 0.02).x(), 0.011, 1e-12);
}

TEST(WalkOdometry, takesOverWhatWasObservedByItsShare) {
  WalkParameters p;
  p.odometry.delay = 0;
  WalkOdometry odometry;
  odometry.reset({});
  const Pose2 planned(0.01, 0.002, 0.1), observed(0.006, -0.002, 0.2);
  const auto moved = [&](double share) {
    p.odometry.observedShare = share;
    return odometry.update(planned, {}, false, p, 0.02, observed);
  };
  EXPECT_NEAR(moved(0).x(), 0.01, 1e-12);
  EXPECT_NEAR(moved(0.5).x(), 0.008, 1e-12);
  EXPECT_NEAR(moved(0.5).y(), 0, 1e-12);
  EXPECT_NEAR(moved(0.5).heading, 0.15, 1e-12);
  EXPECT_NEAR(moved(1).y(), -0.002, 1e-12);
}

}  // namespace
}  // namespace plumbline::walking
