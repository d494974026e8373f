#include "modules/modeling/selflocator/FieldView.h"

#include <gtest/gtest.h>

#include <cmath>

#include "math/Angle.h"
#include "math/Random.h"
#include "modules/modeling/selflocator/FieldMap.h"

using namespace plumbline;

namespace {

TEST(FieldMap, landmarksOfBothTeams) {
  const FieldMap left(FieldSize{}, true), right(FieldSize{}, false);
  EXPECT_EQ(left.landmark(FieldMap::landmarkIndex("F1L")), Vec2(-15, 10));
  EXPECT_EQ(left.landmark(FieldMap::landmarkIndex("G2R")), Vec2(15, -1.05));
  EXPECT_EQ(right.landmark(FieldMap::landmarkIndex("F1L")), Vec2(15, -10)) << "the right team's own frame";
  EXPECT_EQ(FieldMap::landmarkIndex("B"), -1);
  EXPECT_EQ(FieldMap::landmarkIndex(""), -1);
}

TEST(FieldMap, hasTheLeaguesLines) {
  const FieldMap map(FieldSize{}, true);
  double total = 0;
  for (const FieldSegment& segment : map.segments()) {
    total += segment.length;
    EXPECT_NEAR(segment.direction.norm(), 1, 1e-12);
    EXPECT_NEAR(segment.direction.dot(segment.normal), 0, 1e-12);
  }
  const double ring = 10 * 2 * 2 * std::sin(fromDegrees(18));
  EXPECT_NEAR(total, 20 + 2 * 20 + 2 * 30 + 2 * (6 + 2 * 1.8) + ring, 1e-9);
}

TEST(FieldView, isAsSureOfAPointAsTheNoiseAllows) {
  const Pose3 T_ground_head = translation(0, 0, 1);
  const double down = fromDegrees(-30);
  VisionModel none;
  none.distance = none.distanceShare = none.azimuth = none.elevation = none.offset = none.tilt = 0;
  const auto covariance = [&](const VisionModel& noise) {
    return projectToGround(2, 0, down, T_ground_head, noise).covariance;
  };
  VisionModel aside = none, along = none, above = none, tilted = none;
  aside.azimuth = along.distanceShare = above.elevation = tilted.tilt = 0.01;
  EXPECT_NEAR(covariance(aside)(1, 1), std::pow(0.02 * std::cos(down), 2), 1e-12);
  EXPECT_NEAR(covariance(aside)(0, 0), 0, 1e-12);
  EXPECT_NEAR(covariance(along)(0, 0), std::pow(0.02 * std::cos(down), 2), 1e-12);
  EXPECT_NEAR(covariance(above)(0, 0), std::pow(0.02 * std::sin(down), 2), 1e-12);
  EXPECT_NEAR(covariance(tilted)(1, 1), std::pow(0.01, 2), 1e-12) << "1 m below the head";
}

TEST(FieldView, projectsThroughTheHeadsPose) {
  const Pose3 T_ground_head = translation(0.02, 0, 0.5) * rotationZ(pi / 2) * rotationY(pi / 4);
  const GroundPoint point = projectToGround(1, 0, 0, T_ground_head, {});
  EXPECT_NEAR(point.position.x(), 0.02, 1e-12);
  EXPECT_NEAR(point.position.y(), std::sqrt(0.5), 1e-12);
  EXPECT_NEAR(point.height, 0.5 - std::sqrt(0.5), 1e-12);
  EXPECT_TRUE((point.covariance * point.information).isIdentity(1e-9));
}

TEST(FieldView, covarianceIsThatOfManyNoisyPoints) {
  const Pose3 T_ground_head = translation(0, 0, 0.5) * rotationZ(0.4) * rotationY(0.3);
  VisionModel noise;
  noise.offset = noise.tilt = 0;
  const double distance = 8, azimuth = 0.7, elevation = -0.1;
  const GroundPoint expected = projectToGround(distance, azimuth, elevation, T_ground_head, noise);
  Random random(1);
  Mat2 sum = Mat2::Zero();
  const int n = 20000;
  for (int i = 0; i < n; ++i) {
    const double d =
        distance + std::hypot(noise.distanceShare * distance, noise.distance) * random.gaussian();
    const double a = azimuth + noise.azimuth * random.gaussian();
    const double e = elevation + noise.elevation * random.gaussian();
    const Vec2 off = projectToGround(d, a, e, T_ground_head, noise).position - expected.position;
    sum += off * off.transpose() / n;
  }
  EXPECT_LT((sum - expected.covariance).norm(), 0.05 * expected.covariance.norm());
}

TEST(FieldView, knowsTheBorderOfTheImage) {
  const double border = std::tan(VisionModel().imageBorder);
  EXPECT_FALSE(atImageBorder(0, 0, border));
  EXPECT_FALSE(atImageBorder(fromDegrees(58), fromDegrees(-20), border));
  EXPECT_TRUE(atImageBorder(fromDegrees(-59.9), 0, border));
  EXPECT_TRUE(atImageBorder(0, fromDegrees(-59.9), border));
  // The lower border is a plane: beside the middle its elevation is smaller (a line of the league's samples).
  EXPECT_TRUE(atImageBorder(fromDegrees(-32.67), fromDegrees(-55.58), border));
  const double narrow = std::tan(fromDegrees(30));
  EXPECT_TRUE(atImageBorder(fromDegrees(31), 0, narrow));
  EXPECT_FALSE(atImageBorder(fromDegrees(29), 0, narrow));
}

}  // namespace
