#include "gap/diagnosis/ValueFit.h"

#include <gtest/gtest.h>

#include "../TwoJointArm.h"

namespace plumbline::gap {
namespace {

TEST(ValueFitTest, findsValuesFromFarOff) {
  const Mechanism arm = twoJointArm();
  Plant reality = nominalPlant(arm);
  reality.joints[1].viscous = 0.1;
  const Evidence evidence({recorded(reality, armTrial(arm, 6), 5e-4, 3)});
  const Evaluator evaluator(arm, evidence);
  const Effect* effect = findEffect("viscous_friction");
  for (const double start : {0.01, 0.09, 0.4}) {
    const FittedCause fitted =
        fitValue(evaluator, {effect, findPlace(*effect, arm, "elbow", ""), start, 0}, {});
    EXPECT_NEAR(fitted.cause.value, 0.1, 0.003) << start;
  }
}

TEST(ValueFitTest, limitsAreFoundAsExactlyAsTheRest) {
  // Its nominal value is far off: the value is fitted on a scale of what it does.
  const Mechanism arm = twoJointArm();
  Plant reality = nominalPlant(arm);
  reality.joints[0].accelerationLimit = 25;
  const Evidence evidence({recorded(reality, armTrial(arm, 6), 5e-4, 3)});
  const Evaluator evaluator(arm, evidence);
  const Effect* effect = findEffect("acceleration_limit");
  EXPECT_DOUBLE_EQ(effect->valueAt(effect->strengthOf(25)), 25);
  EXPECT_DOUBLE_EQ(effect->strengthOf(effect->nominal), 0);
  const FittedCause fitted =
      fitValue(evaluator, {effect, findPlace(*effect, arm, "shoulder", ""), 60, 0}, {});
  EXPECT_NEAR(fitted.cause.value, 25, 0.2);
}

TEST(ValueFitTest, whatMeetsIsFittedTogether) {
  const Mechanism arm = twoJointArm();
  Plant reality = nominalPlant(arm);
  reality.joints[0].coulomb = 0.1;
  reality.joints[1].viscous = 0.1;
  const Evidence evidence({recorded(reality, armTrial(arm, 6), 5e-4, 3)});
  const Evaluator evaluator(arm, evidence);
  const auto cause = [&](const char* id, const char* at, double value) {
    const Effect* effect = findEffect(id);
    return Cause{effect, findPlace(*effect, arm, at, ""), value, 0};
  };
  const Explanation alone = {cause("coulomb_friction", "shoulder", 0.05)};
  EXPECT_EQ(fitTogether(evaluator, alone, 1), alone);
  const Explanation fitted = fitTogether(
      evaluator, {cause("coulomb_friction", "shoulder", 0.08), cause("viscous_friction", "elbow", 0.13)}, 1);
  EXPECT_NEAR(fitted[0].value, 0.1, 0.01);
  EXPECT_NEAR(fitted[1].value, 0.1, 0.01);
  // A share of lost commands is counted; no fit may move it.
  const Explanation withLosses = {fitted[0], cause("command_dropout", "*", 0.12), fitted[1]};
  EXPECT_EQ(fitTogether(evaluator, withLosses, 1)[1], withLosses[1]);
}

}  // namespace
}  // namespace plumbline::gap
