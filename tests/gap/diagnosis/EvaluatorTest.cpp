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

}  // namespace
}  // namespace plumbline::gap
