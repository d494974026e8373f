#include "gap/replay/SolePlate.h"

#include <gtest/gtest.h>

#include <numeric>

namespace plumbline::gap {
namespace {

Mechanism::Foot square() {
  Mechanism::Foot foot;
  for (const double x : {0.05, -0.05})
    for (const double y : {0.03, -0.03}) foot.sensors.push_back({"", Vec3(x, y, 0)});
  return foot;
}

TEST(SolePlate, withinTheOutlineForceAndPlaceAreKept) {
  const std::vector<double> f = plateForces(square(), 20, Vec2(0.01, -0.006));
  EXPECT_NEAR(f[0] + f[1] + f[2] + f[3], 20, 1e-9);
  EXPECT_NEAR(0.05 * (f[0] + f[1] - f[2] - f[3]), 20 * 0.01, 2e-4);
  EXPECT_NEAR(0.03 * (f[0] + f[2] - f[1] - f[3]), 20 * -0.006, 2e-4);
  EXPECT_NEAR(f[0] - f[1], f[2] - f[3], 1e-3);  // a plane
}

TEST(SolePlate, springsDoNotPull) {
  // So far in a corner that a plane over all four would pull at the opposite one.
  const std::vector<double> f = plateForces(square(), 20, Vec2(0.03, 0.02));
  EXPECT_EQ(f[3], 0);
  EXPECT_NEAR(f[0] + f[1] + f[2], 20, 1e-9);
  EXPECT_NEAR(0.05 * (f[0] + f[1] - f[2]), 20 * 0.03, 1e-2);
  EXPECT_NEAR(0.03 * (f[0] + f[2] - f[1]), 20 * 0.02, 1e-2);
}

TEST(SolePlate, beyondTheOutlineTheNearestCarryAll) {
  const std::vector<double> edge = plateForces(square(), 20, Vec2(0.09, 0));
  EXPECT_NEAR(edge[0], 10, 1e-6);
  EXPECT_NEAR(edge[1], 10, 1e-6);
  EXPECT_EQ(edge[2] + edge[3], 0);
  const std::vector<double> corner = plateForces(square(), 20, Vec2(0.2, 0.2));
  EXPECT_NEAR(std::accumulate(corner.begin(), corner.end(), 0.0), 20, 1e-9);
  EXPECT_GT(corner[0], 15);
}

TEST(SolePlate, noForceNoReading) {
  EXPECT_EQ(plateForces(square(), -1, Vec2(0, 0)), std::vector<double>(4, 0.0));
}

}  // namespace
}  // namespace plumbline::gap
