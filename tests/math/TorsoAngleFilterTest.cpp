#include "math/TorsoAngleFilter.h"

#include <gtest/gtest.h>

namespace plumbline {
namespace {

const Vec3 rest(0, 0, 9.81);

TEST(TorsoAngleFilter, followsTheGyro) {
  TorsoAngleFilter filter(0);
  for (int i = 0; i < 50; ++i) filter.update(Vec3(0, 0.5, 0), rest, 0.02);
  EXPECT_NEAR(filter.pitch(), 0.5, 1e-12);
  EXPECT_NEAR(filter.roll(), 0, 1e-12);
}

TEST(TorsoAngleFilter, anglesAreThoseOfPitchAfterRoll) {
  TorsoAngleFilter filter;
  const Mat3 torso = (rotationY(0.3) * rotationX(-0.2)).linear();
  filter.reset(torso.transpose() * Vec3::UnitZ());
  EXPECT_NEAR(filter.pitch(), 0.3, 1e-12);
  EXPECT_NEAR(filter.roll(), -0.2, 1e-12);
}

TEST(TorsoAngleFilter, restPullsADriftedAngleBack) {
  TorsoAngleFilter filter(0.02);
  filter.reset(Vec3(0.3, 0, 1));
  for (int i = 0; i < 500; ++i) filter.update(Vec3::Zero(), rest, 0.02);
  EXPECT_NEAR(filter.pitch(), 0, 1e-4);
}

TEST(TorsoAngleFilter, anAccelerationThatIsNotGravityIsIgnored) {
  TorsoAngleFilter filter(0.5);
  filter.update(Vec3::Zero(), Vec3(30, 0, 9.81), 0.02);
  filter.update(Vec3::Zero(), Vec3::Zero(), 0.02);
  EXPECT_DOUBLE_EQ(filter.pitch(), 0);
}

}  // namespace
}  // namespace plumbline
