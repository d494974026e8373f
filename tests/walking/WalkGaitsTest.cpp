#include "walking/WalkGaits.h"

#include <gtest/gtest.h>

#include <stdexcept>

#include "framework/ConfigFile.h"

namespace plumbline::walking {
namespace {

WalkGaits someGaits() {
  WalkGaits gaits{WalkParameters{}};
  gaits.base.maxForward = 1.0;
  gaits.base.maxBackward = 0.5;
  gaits.base.maxTurn = 2;
  gaits.base.hipHeight = 0.20;
  gaits.corner[0].hipHeight = 0.24;  // forward
  gaits.corner[1].hipHeight = 0.18;  // backward
  gaits.corner[2].hipHeight = 0.20;
  gaits.corner[3].hipHeight = 0.22;  // turn
  return gaits;
}

TEST(WalkGaits, onTheSpotAndAtFullSpeedTheyAreTheSetsGiven) {
  const WalkGaits gaits = someGaits();
  EXPECT_DOUBLE_EQ(gaits.at(Vec2(0, 0), 0).hipHeight, 0.20);
  EXPECT_DOUBLE_EQ(gaits.at(Vec2(1, 0), 0).hipHeight, 0.24);
  EXPECT_DOUBLE_EQ(gaits.at(Vec2(-0.5, 0), 0).hipHeight, 0.18);
  EXPECT_DOUBLE_EQ(gaits.at(Vec2(0, 0), 2).hipHeight, 0.22);
  EXPECT_DOUBLE_EQ(gaits.at(Vec2(0, 0), -2).hipHeight, 0.22);
}

TEST(WalkGaits, betweenTheyAreBlendedByTheShareOfTheSpeed) {
  const WalkGaits gaits = someGaits();
  EXPECT_NEAR(gaits.at(Vec2(0.25, 0), 0).hipHeight, 0.21, 1e-12);
  EXPECT_NEAR(gaits.at(Vec2(0.25, 0), 1).hipHeight, 0.20 + 0.25 * 0.04 + 0.5 * 0.02, 1e-12);
  // More than everything is everything in the same shares.
  EXPECT_NEAR(gaits.at(Vec2(1, 0), 2).hipHeight, 0.23, 1e-12);
}

TEST(WalkGaits, whatMayBeMixedIsWalkedWithTheBase) {
  WalkGaits gaits = someGaits();
  gaits.base.mixForward = 0.5;
  EXPECT_DOUBLE_EQ(gaits.at(Vec2(0.5, 0), 0).hipHeight, 0.20);
  EXPECT_NEAR(gaits.at(Vec2(0.75, 0), 0).hipHeight, 0.22, 1e-12);
  EXPECT_DOUBLE_EQ(gaits.at(Vec2(1, 0), 0).hipHeight, 0.24);
}

TEST(WalkGaits, whatHoldsForTheWholeWalkIsTheBases) {
  WalkGaits gaits = someGaits();
  gaits.corner[0].maxForward = 3;
  gaits.corner[0].odometryDelay = 0.1;
  EXPECT_DOUBLE_EQ(gaits.at(Vec2(1, 0), 0).maxForward, 1.0);
  EXPECT_DOUBLE_EQ(gaits.at(Vec2(1, 0), 0).odometryDelay, WalkParameters{}.odometryDelay);
}

TEST(WalkGaits, aBadValueIsNamedWithItsCorner) {
  WalkGaits gaits = someGaits();
  gaits.corner[2].stepHeight = 5;
  try {
    gaits.check();
    FAIL() << "accepted";
  } catch (const std::invalid_argument& error) {
    EXPECT_STREQ(error.what(), "sideways: walking parameter stepHeight = 5 must be 0.001 to 0.1");
  }
}

TEST(WalkGaits, recoveryIsBlendedOverWhateverIsWalked) {
  WalkGaits gaits = someGaits();
  for (const WalkParameterInfo& info : walkParameterTable())
    if (std::string(info.name) == "stepHeight") gaits.recovery.emplace_back(&info, 0.05);
  const double plain = gaits.at(Vec2(1, 0), 0).stepHeight;
  EXPECT_DOUBLE_EQ(gaits.at(Vec2(1, 0), 0, 1).stepHeight, 0.05);
  EXPECT_NEAR(gaits.at(Vec2(1, 0), 0, 0.5).stepHeight, (plain + 0.05) / 2, 1e-12);
  // What is not named there stays as it was.
  EXPECT_DOUBLE_EQ(gaits.at(Vec2(1, 0), 0, 1).hipHeight, gaits.at(Vec2(1, 0), 0).hipHeight);
  gaits.recovery[0].second = 5;
  try {
    gaits.check();
    FAIL() << "accepted";
  } catch (const std::invalid_argument& error) {
    EXPECT_STREQ(error.what(), "recovery: walking parameter stepHeight = 5 must be 0.001 to 0.1");
  }
}

TEST(WalkGaits, aCornersMissingKeyIsTheBases) {
  const ConfigFile file("walking", {"config", "config/robots/type0"});
  const WalkGaits gaits = readWalkGaits(file.root());
  file.checkUnknown();
  EXPECT_NO_THROW(gaits.check());
  EXPECT_DOUBLE_EQ(gaits.corner[0].feetDistance,
                   file.root().find<double>("forward.feetDistance").value_or(gaits.base.feetDistance));
}

}  // namespace
}  // namespace plumbline::walking
