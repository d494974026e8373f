#include "training/LeanWatch.h"

#include <gtest/gtest.h>

#include "math/Types.h"

namespace plumbline::training {
namespace {

constexpr double cycleOfWatch = 0.02;

Pose3 torsoWithPitch(double pitch) {
  Pose3 torso = Pose3::Identity();
  torso.linear() = Eigen::AngleAxisd(pitch, Vec3::UnitY()).toRotationMatrix();
  return torso;
}

TEST(LeanWatch, aLeanIsTheAngleToThePostureOfBefore) {
  LeanWatch watch;
  for (int k = 0; k < 100; ++k) watch.look(torsoWithPitch(0), cycleOfWatch);
  EXPECT_EQ(watch.greatest(), 0);
  watch.look(torsoWithPitch(0.3), cycleOfWatch);
  EXPECT_NEAR(watch.greatest(), 0.3, 1e-9);
  watch.look(torsoWithPitch(0), cycleOfWatch);
  EXPECT_NEAR(watch.greatest(), 0.3, 1e-9) << "the greatest stays";
}

TEST(LeanWatch, aPostureThatIsHeldIsNoLean) {
  LeanWatch watch;
  // Into a posture of 0.4 rad within 4 s: the mean follows a second behind, that is 0.1 rad.
  for (int k = 0; k < 200; ++k) watch.look(torsoWithPitch(0.4 * k / 200), cycleOfWatch);
  EXPECT_NEAR(watch.greatest(), 0.1, 0.01);
  for (int k = 0; k < 500; ++k) watch.look(torsoWithPitch(0.4), cycleOfWatch);
  EXPECT_NEAR(watch.greatest(), 0.1, 0.01);
}

TEST(LeanWatch, itsHeadingDoesNotMatter) {
  LeanWatch watch;
  for (int k = 0; k < 100; ++k) {
    Pose3 torso = Pose3::Identity();
    torso.linear() = Eigen::AngleAxisd(0.05 * k, Vec3::UnitZ()).toRotationMatrix();
    watch.look(torso, cycleOfWatch);
  }
  EXPECT_NEAR(watch.greatest(), 0, 1e-7);
}

}  // namespace
}  // namespace plumbline::training
