#include "training/FeltFeet.h"

#include <gtest/gtest.h>

namespace plumbline::training {
namespace {

TEST(FeltFeet, areRoundedAsTheServerPrintsThem) {
  simulation::RobotReadings readings;
  readings.leftFoot = simulation::FootForce{Vec3(0.0149, -0.0151, 0.02), Vec3(0.004, -0.006, 21.2349)};
  const walking::FootSensors feet = feltFeet(readings);
  EXPECT_FALSE(feet.foot[1]);
  ASSERT_TRUE(feet.foot[0]);
  EXPECT_NEAR((feet.foot[0]->point - Vec3(0.01, -0.02, 0.02)).norm(), 0, 1e-12);
  EXPECT_NEAR((feet.foot[0]->force - Vec3(0, -0.01, 21.23)).norm(), 0, 1e-12);
}

}  // namespace
}  // namespace plumbline::training
