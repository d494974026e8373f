#include "gap/diagnosis/Growth.h"

#include <gtest/gtest.h>

#include "gap/TwoJointArm.h"
#include "gap/diagnosis/RepeatNoise.h"
#include "gap/diagnosis/Search.h"

namespace plumbline::gap {
namespace {

TEST(GrowthTest, whatIsBesideLostCommandsIsFittedBesideThem) {
  const Mechanism arm = twoJointArm();
  const Plant plant = plantOf(arm, {causeOfArm("coulomb_friction", "elbow", 0.1)});
  const Evidence evidence = evidenceOf(recordedTwice(plant, 5e-4, 0.1), 1);
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
