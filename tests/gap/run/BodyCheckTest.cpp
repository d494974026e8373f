#include "gap/run/BodyCheck.h"

#include <gtest/gtest.h>

#include "PendulumRun.h"
#include "gap/run/RunFile.h"

namespace plumbline::gap {
namespace {

/// What is said of a NAO that sways, with columns times a factor.
std::string said(const std::string& columns, double factor) {
  std::vector<RunWarning> warnings;
  gap::Run run = readRun("tests/data/gap/nao_none_sway", warnings);
  for (auto& [name, column] : run.channels)
    if (name.starts_with(columns))
      for (double& x : column) x *= factor;
  return saidOf(run, "nao_v5");
}

TEST(BodyCheck, anAccelerometerMayBeAFifthOff) {
  EXPECT_EQ(said("acc.", 0.8), "");
  EXPECT_EQ(said("acc.", 1.3), "");
  EXPECT_EQ(
      said("acc.", 0.6),
      "r: acc is left out: its median length is 5.888 m/s^2 instead of about 9.81; check unit, and that "
      "gravity is in\n");
  EXPECT_EQ(
      said("acc.", 1.5),
      "r: acc is left out: its median length is 14.72 m/s^2 instead of about 9.81; check unit, and that "
      "gravity is in\n");
}

TEST(BodyCheck, aGyroInDegreesIsSeenByHowGravityTurns) {
  EXPECT_EQ(said("gyro.", 0.35 * degree), "");
  for (const double share : {0.7, 1.0, 1.9}) {
    const std::string text = said("gyro.", share * degree);
    EXPECT_TRUE(text.starts_with("r: gyro is left out: it turns ")) << share << text;
    EXPECT_NE(text.find(" times as fast as gravity in acc does (gyro."), std::string::npos) << text;
    EXPECT_TRUE(text.ends_with("; is it in degrees?\n")) << text;
  }
}

TEST(BodyCheck, aQuaternionMayBeTwoPerCentTooLong) {
  EXPECT_EQ(said("truth.q", 1.015), "");
  EXPECT_EQ(said("truth.q", 1.024), "r: truth is left out: a quaternion has length 1.024 instead of 1\n");
}

TEST(BodyCheck, solesMayBeFarOffTheRobotsWeight) {
  EXPECT_EQ(said("fsr.", 0.2), "");
  EXPECT_EQ(said("fsr.", 5), "");
  EXPECT_EQ(said("fsr.", 7),
            "r: fsr is left out: their median sum is 364.5, the robot weighs 52.05 N; check the unit\n");
}

}  // namespace
}  // namespace plumbline::gap
