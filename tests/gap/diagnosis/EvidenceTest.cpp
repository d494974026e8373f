#include "gap/diagnosis/Evidence.h"

#include <gtest/gtest.h>

#include "../TwoJointArm.h"

namespace plumbline::gap {
namespace {

TEST(EvidenceTest, weightsAreMultipliedByChannel) {
  const Mechanism arm = twoJointArm();
  const Evidence evidence({recorded(nominalPlant(arm), armTrial(arm, 1.5), 5e-4, 3)});
  const Evidence other =
      evidence.weightedBy([](std::size_t, std::size_t signal) { return signal == 1 ? 0.25 : 1; });
  const std::size_t last = evidence.trials()[0].cycles() - 1;
  ASSERT_GT(evidence.weights(0, 1)[last], 0);
  EXPECT_DOUBLE_EQ(other.weights(0, 0)[last], evidence.weights(0, 0)[last]);
  EXPECT_DOUBLE_EQ(other.weights(0, 1)[last], 0.25 * evidence.weights(0, 1)[last]);
  EXPECT_EQ(other.weights(0, 1).front(), 0) << "what does not count still does not";
}

TEST(EvidenceTest, ofARobotThatStepsTheBodyCountsBetweenStepsAndAShareOfEverySwingIsTheEngines) {
  const Mechanism arm = twoJointArm();
  Trial trial = recorded(nominalPlant(arm), armTrial(arm, 2), 5e-4, 3);
  trial.freeBase = true;
  Signal gyro{"gyro.x", SignalKind::gyro, -1, -1, 0, false, {}};
  for (std::size_t k = 0; k < trial.cycles(); ++k) gyro.values.push_back(k % 4 < 2 ? 0.6 : -0.6);
  trial.signals.push_back(gyro);
  const auto noise = estimateNoise({trial});
  const Evidence onFeet({trial}, noise);
  trial.restarts.push_back({2, {0, 0}, {0, 0}, {1}});
  trial.betweenSteps.assign(trial.cycles(), 1);
  trial.betweenSteps[60] = 0;
  const Evidence stepping({trial}, noise);
  const std::size_t last = trial.signals.size() - 1;
  EXPECT_EQ(stepping.weights(0, last)[60], 0);
  EXPECT_GT(onFeet.weights(0, last)[60], 0);
  EXPECT_GT(stepping.weights(0, 0)[60], 0) << "joints always count";
  // 12 % of 0.6 rad/s.
  EXPECT_NEAR(1 / stepping.weights(0, last)[61] - 1 / onFeet.weights(0, last)[61], 0.072 * 0.072, 1e-9);
}

}  // namespace
}  // namespace plumbline::gap
