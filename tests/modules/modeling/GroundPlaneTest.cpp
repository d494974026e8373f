#include "modules/modeling/attitude/GroundPlane.h"

#include <gtest/gtest.h>

#include <cmath>

#include "math/Angle.h"
#include "math/Random.h"
#include "modules/modeling/attitude/AttitudeFilter.h"

using namespace plumbline;

namespace {

constexpr double height = 0.5, elevationNoise = 0.00214;

/// Ground points before a robot that is tilted, in its torso frame; noise in elevation as SimSpark's.
GroundPlane groundSeenFrom(const Mat3& R_world_torso, Random* random) {
  GroundPlane plane;
  for (int i = 0; i < 20; ++i) {
    const Vec3 world(1 + 0.6 * i, 4 * std::sin(1.7 * i), -height);
    const double noise = random ? elevationNoise * world.norm() * random->gaussian() : 0;
    const double deviation = elevationNoise * world.norm();
    plane.add(R_world_torso.transpose() * (world + Vec3(0, 0, noise)), deviation * deviation);
  }
  return plane;
}

double angleBetween(const Vec3& a, const Vec3& b) { return std::acos(std::min(1.0, a.dot(b))); }

TEST(GroundPlane, exactPointsGiveTheExactNormalWhateverTheTilt) {
  for (const double pitch : {0.0, 0.3, 1.5, -1.4, 3.0}) {
    const Mat3 R = (rotationZ(1) * rotationY(pitch) * rotationX(0.4)).linear();
    GroundPlane::Fit fit;
    ASSERT_TRUE(groundSeenFrom(R, nullptr).fit(Vec3::Zero(), fit));
    EXPECT_LT((fit.up - Vec3(R.row(2))).norm(), 1e-7) << pitch;
    EXPECT_NEAR(fit.up.dot(fit.axes[0]), 0, 1e-7);
    EXPECT_LE(fit.variances[0], fit.variances[1]);
  }
}

TEST(GroundPlane, errorIsAsLargeAsItSays) {
  Random random(3);
  double distance = 0;
  const int n = 500;
  for (int i = 0; i < n; ++i) {
    GroundPlane::Fit fit;
    ASSERT_TRUE(groundSeenFrom(Mat3::Identity(), &random).fit(Vec3::Zero(), fit));
    for (std::size_t k = 0; k < 2; ++k) {
      const double lean = Vec3::UnitZ().dot(fit.axes[k]);
      distance += lean * lean / fit.variances[k] / n;
    }
  }
  EXPECT_NEAR(distance, 2, 0.3) << "two degrees of freedom";
}

TEST(GroundPlane, pointsThatShowNoPlaneGiveNone) {
  GroundPlane::Fit fit;
  GroundPlane plane;
  EXPECT_FALSE(plane.fit(Vec3::Zero(), fit));
  for (int i = 0; i < 10; ++i) plane.add(Vec3(i, 1, -0.5), 1e-4);
  EXPECT_FALSE(plane.fit(Vec3::Zero(), fit)) << "on one line";
  for (int i = 0; i < 10; ++i) plane.add(Vec3(i, 3 * std::sin(5.0 * i), std::cos(3.0 * i)), 1e-4);
  EXPECT_FALSE(plane.fit(Vec3::Zero(), fit)) << "a cloud";
  plane.clear();
  for (int i = 0; i < 1000; ++i) plane.add(Vec3(i % 7, i % 5, -0.5), 1e-4);
  EXPECT_TRUE(plane.fit(Vec3::Zero(), fit)) << "more than it can hold";
}

TEST(AttitudeFilter, theSeenGroundCorrectsAPersistentError) {
  // The gyro has a bias that would tilt it by a degree a second.
  AttitudeFilter filter;
  Random random(4);
  double worst = 0;
  for (int i = 0; i < 500; ++i) {
    const Vec3 shake(0, 0, 2 * std::sin(i));  // never still
    filter.update(Vec3(fromDegrees(1), 0, 0), Vec3(0, 0, 9.81) + shake, 0.02);
    GroundPlane::Fit fit;
    if (i % 3 == 0 && groundSeenFrom(Mat3::Identity(), &random).fit(Vec3::Zero(), fit)) filter.seeGround(fit);
    if (i > 50) worst = std::max(worst, angleBetween(filter.up(), Vec3::UnitZ()));
  }
  EXPECT_LT(toDegrees(worst), 2.5);
  EXPECT_GT(toDegrees(worst), 0.1) << "the test tests something";
}

TEST(AttitudeFilter, aRobotPutDownDifferentlySeesItInTwoImages) {
  AttitudeFilter filter;
  for (int i = 0; i < 50; ++i) filter.update(Vec3::Zero(), Vec3(0, 0, 9.81), 0.02);
  const Mat3 R = (rotationY(fromDegrees(70))).linear();
  Random random(5);
  GroundPlane::Fit fit;
  ASSERT_TRUE(groundSeenFrom(R, &random).fit(Vec3::Zero(), fit));
  filter.seeGround(fit);
  EXPECT_LT(toDegrees(angleBetween(filter.up(), Vec3::UnitZ())), 0.01) << "one may be wrong";
  filter.seeGround(fit);
  EXPECT_LT(toDegrees(angleBetween(filter.up(), Vec3(R.row(2)))), 0.3);
}

}  // namespace
