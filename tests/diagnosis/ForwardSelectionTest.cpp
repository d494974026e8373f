#include "gap/diagnosis/ForwardSelection.h"

#include <gtest/gtest.h>

#include "gap/TwoJointArm.h"
#include "gap/diagnosis/CauseSearch.h"
#include "gap/diagnosis/RepeatNoise.h"

namespace plumbline::gap {
namespace {

TEST(ForwardSelectionTest, anotherCauseIsFittedTogetherWithLostCommands) {
  const Mechanism arm = twoJointArm();
  const Plant plant = plantOf(arm, {causeOfArm("coulomb_friction", "elbow", 0.1)});
  const Evidence evidence = evidenceOf(recordedTwice(plant, 5e-4, 0.1), 1);
  Evaluator fine(arm, evidence), coarse(arm, evidence, coarseSteps());
  const DiagnosisOptions options;
  ForwardSelection selection(fine, coarse, options);
  selection.worstBefore = 10;
  selection.grow();
  ASSERT_EQ(selection.causes.size(), 2u);
  for (const Cause& cause : selection.causes) {
    if (cause.effect->decoded) {
      EXPECT_NEAR(cause.value, 0.1, 0.03);
    } else {
      EXPECT_EQ(cause.effect->id, "coulomb_friction");
      EXPECT_NEAR(cause.value, 0.1, 0.002);
    }
  }
  EXPECT_EQ(selection.causes, fine.base());
  EXPECT_LT(selection.remainder().size(), 0.6);
}

}  // namespace
}  // namespace plumbline::gap
