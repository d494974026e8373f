#include "gap/diagnosis/LossEcho.h"

#include <gtest/gtest.h>

#include "../Pendulum.h"

namespace plumbline::gap {
namespace {

TEST(LossEchoTest, aStiffServoTellsAtOnce) {
  const Plant plant = nominalPlant(twoJointArm());
  const Evidence evidence(recordedTwice(plant, 5e-4, 0));
  const LossEcho echo = lossEcho(plant, evidence, 0, 14);
  EXPECT_EQ(echo.told, LossEcho::leastTold);
  EXPECT_LT(echo.over, 50u);
}

TEST(LossEchoTest, aHeavyPendulumSwingsOn) {
  const Plant plant = nominalPlant(pendulum());
  const Evidence evidence(pendulumRecordedTwice(plant, 0));
  const LossEcho echo = lossEcho(plant, evidence, 0, 14);
  EXPECT_GT(echo.told, 9u);
  EXPECT_LT(echo.told, 30u);
  EXPECT_GT(echo.over, 30u);
  EXPECT_LT(echo.over, LossEcho::reach);
}

TEST(LossEchoTest, lossesThatDoNotShowSayNothing) {
  const Plant plant = nominalPlant(pendulum());
  const Evidence evidence(pendulumRecordedTwice(plant, 0));
  const LossEcho echo = lossEcho(plant, evidence, 0, 1e9);
  EXPECT_EQ(echo.told, LossEcho::leastTold);
  EXPECT_EQ(echo.over, LossEcho::leastOver);
}

}  // namespace
}  // namespace plumbline::gap
