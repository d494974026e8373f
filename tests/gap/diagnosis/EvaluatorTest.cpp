#include "gap/diagnosis/Evaluator.h"

#include <gtest/gtest.h>

#include "../TwoJointArm.h"

namespace plumbline::gap {
namespace {

class EvaluatorTest : public ::testing::Test {
protected:
  static Cause at(const char* id, const char* place, double value) {
    const Effect* effect = findEffect(id);
    return {effect, findPlace(*effect, twoJointArm(), place, ""), value, 0};
  }

  const Mechanism arm = twoJointArm();
  const Evidence evidence{{recorded(nominalPlant(arm), armTrial(arm, 3), 5e-4, 3)}};
};

TEST_F(EvaluatorTest, aBaseThatChangedIsAsOneThatBeganSo) {
  const Explanation causes = {at("coulomb_friction", "elbow", 0.05), at("servo_gain", "shoulder", 0.8)};
  Evaluator direct(arm, evidence), stepwise(arm, evidence);
  direct.setBase(causes);
  stepwise.setBase({causes[0]});
  stepwise.setBase({causes[1]});
  stepwise.setBase(causes);
  EXPECT_EQ(direct.baseFit().squares, stepwise.baseFit().squares);
  EXPECT_GT(direct.baseFit().judging, 1000);
}

TEST_F(EvaluatorTest, anExplanationCostsWhatItCostsAsABase) {
  Evaluator evaluator(arm, evidence);
  const Explanation causes = {at("command_delay", "*", 0.01)};
  const Fit fit = evaluator.of(causes), with = evaluator.with(causes[0]);
  evaluator.setBase(causes);
  EXPECT_NEAR(fit.fitting, evaluator.baseFit().fitting, 1e-6 * fit.fitting);
  EXPECT_DOUBLE_EQ(fit.judging, with.judging);
  EXPECT_EQ(evaluator.of(causes).judging, evaluator.baseFit().judging);
}

/// A recording of an elbow that hunts between the flanks of its gear, with teeth and a phase of its own.
Evidence huntingElbow(const Mechanism& arm, double play) {
  Plant plant = nominalPlant(arm);
  plant.joints[1].backlash = play;
  plant.joints[1].linkEncoder = true;
  plant.joints[1].toothStiffness = 3000;
  plant.joints[1].toothDamping = 0.8;
  ReplayOptions options;
  options.settle = 1.0211;
  return Evidence{{recorded(plant, armTrial(arm, 12), 5e-4, 3, options)}};
}

TEST_F(EvaluatorTest, playThatHuntsFitsBestAtItsOwnSize) {
  const Evidence hunting = huntingElbow(arm, 0.04);
  Evaluator evaluator(arm, hunting);
  const auto fitting = [&](double play) {
    Cause cause = at("backlash", "elbow", play);
    cause.variant = 1;
    return evaluator.with(cause).fitting;
  };
  EXPECT_LT(fitting(0.04), 0.2 * evaluator.baseFit().fitting);
  EXPECT_LT(fitting(0.04), fitting(0.02));
  EXPECT_LT(fitting(0.04), fitting(0.08));
}

TEST_F(EvaluatorTest, aBaseInDoubtCostsWhatItCostsAsACandidate) {
  const Evidence hunting = huntingElbow(arm, 0.04);
  Evaluator evaluator(arm, hunting);
  Cause play = at("backlash", "elbow", 0.04);
  play.variant = 1;
  const double asCandidate = evaluator.with(play).judging, nominal = evaluator.baseFit().judging;
  evaluator.setBase({play});
  EXPECT_NEAR(asCandidate, evaluator.baseFit().judging, 1e-6 * asCandidate);
  EXPECT_NEAR(evaluator.of({}).judging, nominal, 1e-6 * nominal);
  evaluator.setBase({});
  EXPECT_EQ(evaluator.baseFit().judging, nominal);
}

}  // namespace
}  // namespace plumbline::gap
