#include "gap/replay/Ensemble.h"

#include <gtest/gtest.h>

#include <numeric>

#include "../TwoJointArm.h"

namespace plumbline::gap {
namespace {

Plant armWithPlay(double play, bool linkEncoder) {
  static const Mechanism arm = twoJointArm();
  Plant plant = nominalPlant(arm);
  plant.joints[1].backlash = play;
  plant.joints[1].linkEncoder = linkEncoder;
  return plant;
}

double sumOf(const std::vector<double>& values) { return std::accumulate(values.begin(), values.end(), 0.0); }

TEST(EnsembleTest, withoutALimitCycleThePredictionIsTheReplay) {
  const Trial trial = armTrial(twoJointArm(), 3);
  const Plant plant = armWithPlay(0.03, false);
  const Prediction one = replay(plant, trial), predicted = predictEnsemble(plant, trial, {});
  EXPECT_EQ(one.values, predicted.values);
  EXPECT_TRUE(predicted.variance.empty());
}

TEST(EnsembleTest, theVarianceOfALimitCycleGrowsWithItsBacklash) {
  const Trial trial = recorded(armWithPlay(0.04, true), armTrial(twoJointArm(), 3), 5e-4, 5);
  const Prediction narrow = predictEnsemble(armWithPlay(0.01, true), trial, {}),
                   wide = predictEnsemble(armWithPlay(0.04, true), trial, {});
  ASSERT_EQ(wide.variance.size(), trial.signals.size());
  ASSERT_EQ(wide.variance[1].size(), trial.cycles());
  for (const double variance : wide.variance[1]) ASSERT_GE(variance, 0);
  const double narrowSum = sumOf(narrow.variance[1]), wideSum = sumOf(wide.variance[1]),
               n = static_cast<double>(trial.cycles());
  EXPECT_GT(std::sqrt(wideSum / n), 0.002);
  EXPECT_LT(std::sqrt(wideSum / n), 0.04);  // not beyond the backlash
  EXPECT_GT(wideSum, 3 * narrowSum);
}

TEST(EnsembleTest, wideBacklashHasALimitCycleWhereverTheEncoderIs) {
  const Trial trial = recorded(armWithPlay(0.15, false), armTrial(twoJointArm(), 3), 5e-4, 5);
  EXPECT_TRUE(hasLimitCycle(armWithPlay(0.11, false).joints[1]));
  EXPECT_FALSE(hasLimitCycle(armWithPlay(0.09, false).joints[1]));
  EXPECT_FALSE(predictEnsemble(armWithPlay(0.15, false), trial, {}).variance.empty());
}

TEST(EnsembleTest, backlashBelowTheEncodersResolutionHasNoLimitCycle) {
  EXPECT_FALSE(hasLimitCycle(armWithPlay(0.0003, true).joints[1]));
  EXPECT_TRUE(hasLimitCycle(armWithPlay(0.0008, true).joints[1]));
}

TEST(EnsembleTest, aJointThatDriftsAwayHasNoLimitCycle) {
  const Plant plant = armWithPlay(0.04, true);
  Trial trial = recorded(plant, armTrial(twoJointArm(), 3), 5e-4, 5);
  const double ofLimitCycle = sumOf(predictEnsemble(plant, trial, {}).variance[1]);
  for (std::size_t k = 0; k < trial.cycles(); ++k)
    trial.signals[1].values[k] += 0.2 * std::sin(2 * M_PI * 0.3 * trial.time[k]);
  EXPECT_LT(sumOf(predictEnsemble(plant, trial, {}).variance[1]), 0.05 * ofLimitCycle);
}

TEST(EnsembleTest, aJointThatMovesSmoothlyHasNoLimitCycle) {
  // It has friction and is off by about the backlash, but nothing in it is as quick as a limit cycle.
  Plant rubbing = armWithPlay(0, false);
  rubbing.joints[1].coulomb = 0.3;
  const Trial trial = recorded(rubbing, armTrial(twoJointArm(), 3), 5e-4, 5);
  EXPECT_EQ(sumOf(predictEnsemble(armWithPlay(0.04, true), trial, {}).variance[1]), 0);
}

TEST(EnsembleTest, whereTheErrorIsFarBeyondALimitCycleItHasNoVariance) {
  const Plant plant = armWithPlay(0.04, true);
  Trial trial = recorded(plant, armTrial(twoJointArm(), 4), 5e-4, 5);
  const auto varianceIn = [&](double from, double to) {
    const Prediction predicted = predictEnsemble(plant, trial, {});
    double sum = 0;
    for (std::size_t k = 0; k < trial.cycles(); ++k)
      if (trial.time[k] - trial.time[0] >= from && trial.time[k] - trial.time[0] < to)
        sum += predicted.variance[1][k];
    return sum;
  };
  const double before = varianceIn(0.5, 1.74), later = varianceIn(2.3, 2.7);
  ASSERT_GT(later, 0);
  // As quick as the limit cycle, but five times as wide as the backlash.
  for (std::size_t k = 0; k < trial.cycles(); ++k)
    if (trial.time[k] - trial.time[0] >= 2 && trial.time[k] - trial.time[0] < 3)
      trial.signals[1].values[k] += k % 2 == 0 ? 0.2 : -0.2;
  EXPECT_EQ(varianceIn(2.3, 2.7), 0);
  // The squares are smoothed over a quarter of a second to each side.
  EXPECT_EQ(varianceIn(1.8, 3.2), 0);
  EXPECT_NEAR(varianceIn(0.5, 1.74), before, 1e-9 * before);
}

TEST(EnsembleTest, jointsThatAreNotReplayedHaveNoLimitCycle) {
  const Trial trial = armTrial(twoJointArm(), 3);
  ReplayOptions options;
  options.joints = {0};
  EXPECT_TRUE(predictEnsemble(armWithPlay(0.04, true), trial, options).variance.empty());
}

}  // namespace
}  // namespace plumbline::gap
