#include "robot/SupplyRail.h"

#include <gtest/gtest.h>

#include <cmath>

namespace plumbline {
namespace {

std::vector<JointPlant> twoDrives(double sag) {
  std::vector<JointPlant> drives(2);
  drives[0].maxTorque = 3;
  drives[1].maxTorque = 1;
  for (JointPlant& drive : drives) drive.supplySag = sag;
  return drives;
}

TEST(SupplyRailTest, fallsWithTheShareOfAllTorquesOverTenMilliseconds) {
  const auto drives = twoDrives(0.5);
  SupplyRail rail(drives);
  EXPECT_TRUE(rail.hasVoltageDrop());
  EXPECT_DOUBLE_EQ(rail.left(drives[0]), 1);
  constexpr double h = 1e-5;
  for (int i = 0; i < 1000; ++i) rail.take(2, h);
  EXPECT_NEAR(rail.left(drives[0]), 1 - 0.5 * 0.5 * (1 - std::exp(-1)), 1e-4);
  for (int i = 0; i < 100000; ++i) rail.take(2, h);
  EXPECT_NEAR(rail.left(drives[1]), 0.75, 1e-9);
  rail.restart();
  EXPECT_DOUBLE_EQ(rail.left(drives[1]), 1);
}

TEST(SupplyRailTest, aStepLongerThanItsTimeEndsAtTheLoad) {
  const auto drives = twoDrives(0.5);
  SupplyRail rail(drives);
  rail.take(4, 1);
  EXPECT_DOUBLE_EQ(rail.left(drives[0]), 0.5);
}

TEST(SupplyRailTest, neverFallsBelowATenth) {
  const auto drives = twoDrives(3);
  SupplyRail rail(drives);
  rail.take(4, 1);
  EXPECT_DOUBLE_EQ(rail.left(drives[0]), 0.1);
}

TEST(SupplyRailTest, aStiffOneStaysWhatever) {
  const auto drives = twoDrives(0);
  SupplyRail rail(drives);
  EXPECT_FALSE(rail.hasVoltageDrop());
  rail.take(4, 1);
  EXPECT_EQ(rail.left(drives[0]), 1);
}

}  // namespace
}  // namespace plumbline
