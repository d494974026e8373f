#include "gap/diagnosis/Growth.h"

#include <gtest/gtest.h>

#include "../TwoJointArm.h"
#include "gap/diagnosis/RepeatNoise.h"
#include "gap/diagnosis/Search.h"

namespace plumbline::gap {
namespace {

/// The arm with these causes, recorded twice, each time with a tenth of other commands lost.
std::vector<Trial> recordedWith(const Explanation& causes) {
  std::vector<Trial> trials;
  for (const std::uint64_t seed : {11, 12}) {
    Random random(seed);
    std::vector<std::uint8_t> lost(600, 0);
    for (auto& cycle : lost) cycle = random.uniform() < 0.1;
    ReplayOptions options;
    options.lostCycles = &lost;
    trials.push_back(
        recorded(plantOf(twoJointArm(), causes), armTrial(twoJointArm(), 6), 5e-4, seed, options));
  }
  return trials;
}

TEST(GrowthTest, whatIsBesideLostCommandsIsFittedBesideThem) {
  const Mechanism arm = twoJointArm();
  const Evidence evidence = evidenceOf(recordedWith({causeOfArm("coulomb_friction", "elbow", 0.1)}), 1);
  Evaluator fine(arm, evidence), coarse(arm, evidence, coarseSteps());
  const DiagnosisOptions options;
  Growth growth(fine, coarse, options);
  growth.worstBefore = 10;
  growth.grow();
  ASSERT_EQ(growth.causes.size(), 2u);
  for (const Cause& cause : growth.causes) {
    if (cause.effect->decoded) {
      EXPECT_NEAR(cause.value, 0.1, 0.03);
    } else {
      EXPECT_EQ(cause.effect->id, "coulomb_friction");
      EXPECT_NEAR(cause.value, 0.1, 0.002);
    }
  }
  EXPECT_EQ(growth.causes, fine.base());
  EXPECT_LT(growth.remainder().size(), 0.6);
}

}  // namespace
}  // namespace plumbline::gap
