#include "walking/estimation/SpeedScale.h"

#include <gtest/gtest.h>

#include <cmath>

namespace plumbline::walking {
namespace {

/// Walks at a speed for some seconds as a robot does that is so much faster than planned.
void walk(SpeedScale& scale, const Vec3& aimed, const Vec3& faster, double seconds, double average = 10) {
  for (int i = 0; i < std::lround(seconds / 0.01); ++i)
    scale.update(aimed, scale.planned(aimed).cwiseProduct(faster), average, 0.01);
}

TEST(SpeedScaleTest, theRobotComesToWalkAsItIsToWalk) {
  SpeedScale scale;
  const Vec3 aimed(0.2, -0.1, 0.8), faster(1.1, 0.9, 1.05);
  walk(scale, aimed, faster, 20);
  const Vec3 walked = scale.planned(aimed).cwiseProduct(faster);
  EXPECT_NEAR(walked.x(), 0.2, 0.001);
  EXPECT_NEAR(walked.y(), -0.1, 0.002);
  EXPECT_NEAR(walked.z(), 0.8, 0.003);
  // What is learnt at one speed holds at others, backward too.
  EXPECT_NEAR(scale.planned(Vec3(-0.1, 0, 0)).x(), -0.1 / 1.1, 0.001);
}

TEST(SpeedScaleTest, aSecondAtALowSpeedCountsAboutHalf) {
  // 0.1 m/s and 0.4 rad/s, a fifth faster than planned: after a second (and what does not count) nearly half
  // of that is believed, since slower is planned meanwhile.
  const auto believed = [](const Vec3& aimed, int axis) {
    SpeedScale scale;
    walk(scale, aimed, Vec3::Constant(1.2), 1.6, 1e9);
    return aimed[axis] / scale.planned(aimed)[axis];
  };
  EXPECT_NEAR(believed(Vec3(0.1, 0, 0), 0), 1.095, 0.003);
  EXPECT_NEAR(believed(Vec3(0, -0.1, 0), 1), 1.095, 0.003);
  EXPECT_NEAR(believed(Vec3(0, 0, 0.4), 2), 1.095, 0.003);
}

TEST(SpeedScaleTest, nothingIsLearntWhileTheSpeedChangesOrWhereItIsNotAskedFor) {
  SpeedScale scale;
  for (int i = 0; i < 100; ++i) walk(scale, Vec3(0.2 + 0.001 * i, 0, 0), Vec3(1.2, 1, 1), 0.5);
  EXPECT_EQ(scale.planned(Vec3(0.2, 0.1, 1)), Vec3(0.2, 0.1, 1));
  walk(scale, Vec3(0.2, 0, 0), Vec3(1.2, 1, 1), 20, 0);
  EXPECT_EQ(scale.planned(Vec3(0.2, 0.1, 1)), Vec3(0.2, 0.1, 1));
}

TEST(SpeedScaleTest, aRobotThatIsHeldIsNotAskedForMoreAndMore) {
  SpeedScale scale;
  walk(scale, Vec3(0.2, 0, 0), Vec3::Zero(), 60);
  EXPECT_DOUBLE_EQ(scale.planned(Vec3(0.2, 0, 0)).x(), 0.25);
}

}  // namespace
}  // namespace plumbline::walking
