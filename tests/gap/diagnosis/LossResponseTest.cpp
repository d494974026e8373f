#include "gap/diagnosis/LossResponse.h"

#include <gtest/gtest.h>

#include "../Pendulum.h"

namespace plumbline::gap {
namespace {

TEST(LossResponseTest, aStiffServoTellsAtOnce) {
  const Plant plant = nominalPlant(twoJointArm());
  const Evidence evidence(recordedTwice(plant, 5e-4, 0));
  const LossResponse response = lossResponse(plant, evidence, 0, 14);
  EXPECT_EQ(response.detectionCycles, LossResponse::minDetection);
  EXPECT_LT(response.settlingCycles, 50u);
}

TEST(LossResponseTest, aHeavyPendulumSwingsOn) {
  const Plant plant = nominalPlant(pendulum());
  const Evidence evidence(pendulumRecordedTwice(plant, 0));
  const LossResponse response = lossResponse(plant, evidence, 0, 14);
  EXPECT_GT(response.detectionCycles, 9u);
  EXPECT_LT(response.detectionCycles, 30u);
  EXPECT_GT(response.settlingCycles, 30u);
  EXPECT_LT(response.settlingCycles, LossResponse::reach);
}

TEST(LossResponseTest, lossesThatDoNotShowSayNothing) {
  const Plant plant = nominalPlant(pendulum());
  const Evidence evidence(pendulumRecordedTwice(plant, 0));
  const LossResponse response = lossResponse(plant, evidence, 0, 1e9);
  EXPECT_EQ(response.detectionCycles, LossResponse::minDetection);
  EXPECT_EQ(response.settlingCycles, LossResponse::minSettling);
}

}  // namespace
}  // namespace plumbline::gap
