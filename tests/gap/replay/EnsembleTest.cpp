#include "gap/replay/Ensemble.h"

#include <gtest/gtest.h>

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

TEST(EnsembleTest, whatDoesNotHuntIsForetoldAsItIsReplayed) {
  const Trial trial = armTrial(twoJointArm(), 3);
  const Plant plant = armWithPlay(0.03, false);
  const Prediction one = replay(plant, trial), foretold = replayForetold(plant, trial, {});
  EXPECT_EQ(one.values, foretold.values);
  EXPECT_TRUE(foretold.scatter.empty());
}

TEST(EnsembleTest, huntingThatNobodySeesIsInDoubt) {
  const Trial trial = armTrial(twoJointArm(), 3);
  const Prediction narrow = replayForetold(armWithPlay(0.01, true), trial, {}),
                   wide = replayForetold(armWithPlay(0.04, true), trial, {});
  ASSERT_EQ(wide.scatter.size(), trial.signals.size());
  ASSERT_EQ(wide.scatter[1].size(), trial.cycles());
  double narrowSum = 0, wideSum = 0;
  for (std::size_t k = 0; k < trial.cycles(); ++k) {
    ASSERT_GE(wide.scatter[1][k], 0);
    narrowSum += narrow.scatter[1][k];
    wideSum += wide.scatter[1][k];
  }
  const double n = static_cast<double>(trial.cycles());
  EXPECT_GT(std::sqrt(wideSum / n), 0.002);
  EXPECT_LT(std::sqrt(wideSum / n), 0.04);  // not beyond the play
  EXPECT_GT(wideSum, 3 * narrowSum);
}

TEST(EnsembleTest, jointsThatAreNotReplayedCannotHunt) {
  const Trial trial = armTrial(twoJointArm(), 3);
  ReplayOptions options;
  options.joints = {0};
  EXPECT_TRUE(replayForetold(armWithPlay(0.04, true), trial, options).scatter.empty());
}

}  // namespace
}  // namespace plumbline::gap
