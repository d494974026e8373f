#include "gap/diagnosis/Evaluator.h"

#include <gtest/gtest.h>

#include "../LegOnItsFoot.h"
#include "gap/diagnosis/GapMeter.h"

namespace plumbline::gap {
namespace {

class EvaluatorTest : public ::testing::Test {
protected:
  const Mechanism arm = twoJointArm();
  const Evidence evidence{{recorded(nominalPlant(arm), armTrial(arm, 3), 5e-4, 3)}};
};

TEST_F(EvaluatorTest, aBaseThatChangedIsAsOneThatBeganSo) {
  const Explanation causes = {causeOfArm("coulomb_friction", "elbow", 0.05),
                              causeOfArm("servo_gain", "shoulder", 0.8)};
  Evaluator direct(arm, evidence), stepwise(arm, evidence);
  direct.setBase(causes);
  stepwise.setBase({causes[0]});
  stepwise.setBase({causes[1]});
  stepwise.setBase(causes);
  EXPECT_EQ(direct.baseFit().squares, stepwise.baseFit().squares);
  EXPECT_GT(direct.baseFit().judging, 1000);
}

TEST_F(EvaluatorTest, aBaseWithDropoutHasItsPredictionsWhateverCyclesAreGiven) {
  Evaluator evaluator(arm, evidence), other(arm, evidence);
  std::vector<std::vector<std::uint8_t>> lost = {std::vector<std::uint8_t>(300, 0)};
  for (std::size_t k = 20; k < 300; k += 20) lost[0][k] = 1;
  const Explanation dropout = {causeOfArm("command_dropout", "*", 0.05)};
  evaluator.setBase(dropout);
  const double none = evaluator.baseFit().judging;
  evaluator.setLostCycles(lost);
  ASSERT_EQ(evaluator.basePrediction(0).values.size(), 2u);
  EXPECT_GT(evaluator.baseFit().judging, none);
  other.setLostCycles(lost);
  other.setBase(dropout);
  EXPECT_EQ(evaluator.baseFit().squares, other.baseFit().squares);
}

TEST_F(EvaluatorTest, anExplanationCostsWhatItCostsAsABase) {
  Evaluator evaluator(arm, evidence);
  const Explanation causes = {causeOfArm("command_delay", "*", 0.01)};
  const Fit fit = evaluator.of(causes), with = evaluator.with(causes[0]);
  evaluator.setBase(causes);
  EXPECT_NEAR(fit.fitting, evaluator.baseFit().fitting, 1e-6 * fit.fitting);
  EXPECT_DOUBLE_EQ(fit.judging, with.judging);
  EXPECT_EQ(evaluator.of(causes).judging, evaluator.baseFit().judging);
}

TEST_F(EvaluatorTest, aCauseChangesNothingInARecordingThatRanWithoutIt) {
  Trial with = armTrial(arm, 3), less = armTrial(arm, 3);
  with.recording = "with";
  less.recording = "without";
  const Explanation there = {causeOfArm("acceleration_limit", "elbow", 20)};
  const Evidence both(
      {recorded(plantOf(arm, there), with, 5e-4, 3), recorded(nominalPlant(arm), less, 5e-4, 4)});
  Cause cause = there[0];
  cause.inactiveIn = {"without"};
  Evaluator evaluator(arm, both);
  const double nominal = evaluator.baseFit().judging;
  const Fit fit = evaluator.with(cause);
  EXPECT_LT(fit.judging, 0.1 * nominal);
  EXPECT_LT(fit.judging, 0.1 * evaluator.with(there[0]).judging);
  EXPECT_EQ(evaluator.of({cause}).judging, fit.judging);
  evaluator.setBase({cause});
  EXPECT_NEAR(evaluator.baseFit().judging, fit.judging, 1e-6 * fit.judging);
  EXPECT_LT(worstGap(evaluator).size, 0.5);
}

TEST_F(EvaluatorTest, ofARobotThatStepsTheWorstSixthHasGoneAstray) {
  Trial trial = recorded(nominalPlant(arm), armTrial(arm, 6), 5e-4, 3);
  const auto within = [&](double from, double to, double by) {
    Trial off = trial;
    for (std::size_t k = 0; k < off.cycles(); ++k)
      if (off.time[k] >= from && off.time[k] < to) off.signals[1].values[k] += by;
    return off;
  };
  const auto worst = [&](Trial run, bool steps) {
    if (steps) run.restarts.push_back({run.cycles() - 1, {NAN, NAN}, {NAN, NAN}, {}});
    return worstGap(Evaluator(arm, Evidence({run}, estimateNoise({trial})))).size;
  };
  EXPECT_GT(worst(within(2, 3, 0.1), false), 30);
  EXPECT_LT(worst(within(2, 3, 0.1), true), 0.5) << "two of twelve half-seconds";
  EXPECT_GT(worst(within(2, 4, 0.1), true), 1.5) << "a third of a walk is no accident";
}

/// A recording of an elbow that swings between the flanks of its gear, with teeth and a phase of its
/// own.
Evidence elbowWithLimitCycle(const Mechanism& arm, double play) {
  Plant plant = nominalPlant(arm);
  plant.joints[1].backlash = play;
  plant.joints[1].linkEncoder = true;
  plant.joints[1].toothStiffness = 3000;
  plant.joints[1].toothDamping = 0.8;
  ReplayOptions options;
  options.settle = 1.0211;
  return Evidence{{recorded(plant, armTrial(arm, 12), 5e-4, 3, options)}};
}

TEST_F(EvaluatorTest, backlashWithALimitCycleFitsBestAtItsOwnSize) {
  const Evidence evidence = elbowWithLimitCycle(arm, 0.04);
  Evaluator evaluator(arm, evidence);
  const auto fitting = [&](double play) {
    Cause cause = causeOfArm("backlash", "elbow", play);
    cause.variant = 1;
    return evaluator.with(cause).fitting;
  };
  EXPECT_LT(fitting(0.04), 0.2 * evaluator.baseFit().fitting);
  EXPECT_LT(fitting(0.04), fitting(0.02));
  EXPECT_LT(fitting(0.04), fitting(0.08));
}

TEST_F(EvaluatorTest, aBaseInDoubtCostsWhatItCostsAsACandidate) {
  const Evidence evidence = elbowWithLimitCycle(arm, 0.04);
  Evaluator evaluator(arm, evidence);
  Cause play = causeOfArm("backlash", "elbow", 0.04);
  play.variant = 1;
  const double asCandidate = evaluator.with(play).judging, nominal = evaluator.baseFit().judging;
  evaluator.setBase({play});
  EXPECT_NEAR(asCandidate, evaluator.baseFit().judging, 1e-6 * asCandidate);
  EXPECT_NEAR(evaluator.of({}).judging, nominal, 1e-6 * nominal);
  evaluator.setBase({});
  EXPECT_EQ(evaluator.baseFit().judging, nominal);
}

/// A leg that hangs and stands, its hip off by `offset` in both.
std::vector<Trial> legRuns(double offset) {
  std::vector<Trial> trials;
  for (const bool floatingBase : {false, true}) {
    trials.push_back(recorded(nominalPlant(legOnItsFoot()), legTrial(floatingBase), 5e-4, 3));
    for (double& value : trials.back().signals[0].values) value += offset;
  }
  return trials;
}

TEST(EvaluatorOnFeetTest, squaresGrowByTheirLogarithm) {
  const Mechanism leg = legOnItsFoot();
  const auto squares = [&](double offset, std::size_t trial) {
    const Evidence evidence(std::vector<Trial>{legRuns(offset)[trial]});
    return Evaluator(leg, evidence).baseFit().fitting;
  };
  EXPECT_NEAR(squares(0.2, 0) / squares(0.1, 0), 4, 0.05);
  const Evidence evidence(std::vector<Trial>{legRuns(0)[1]});
  std::size_t samples = 0;
  Prediction nothing;
  nothing.values.assign(2, std::vector<double>(evidence.trials()[0].cycles(), 0));
  evidence.forEach(0, 0, nothing, [&](std::size_t k, double, double) {
    samples += Evidence::forFitting(evidence.block(0, k));
  });
  EXPECT_NEAR(squares(0.2, 1) - squares(0.1, 1), 25 * std::log(4) * static_cast<double>(samples),
              0.02 * 25 * std::log(4) * static_cast<double>(samples));
}

TEST(EvaluatorOnFeetTest, aCandidateCostsThereWhatItCostsAsABase) {
  const Mechanism leg = legOnItsFoot();
  const Evidence evidence(legRuns(0.02));
  Evaluator evaluator(leg, evidence);
  const Effect* effect = findEffect("joint_offset");
  const Cause cause{effect, findPlace(*effect, leg, "hip", ""), -0.02, 0};
  const double asCandidate = evaluator.with(cause).judging;
  evaluator.setBase({cause});
  EXPECT_NEAR(asCandidate, evaluator.baseFit().judging, 1e-6 * asCandidate);
}

TEST(EvaluatorOnFeetTest, runsOnTheFeetMayBeLeftOut) {
  const Mechanism leg = legOnItsFoot();
  const Evidence evidence(legRuns(0.02)), fixedBase(std::vector<Trial>{legRuns(0.02)[0]});
  Evaluator evaluator(leg, evidence);
  const double whole = evaluator.baseFit().judging;
  EXPECT_TRUE(evaluator.hasFloatingBase());
  evaluator.leaveFloatingBaseOut(true);
  EXPECT_FALSE(evaluator.hasFloatingBase());
  EXPECT_TRUE(std::isnan(evaluator.chi(1, 0)));
  EXPECT_DOUBLE_EQ(evaluator.baseFit().judging, Evaluator(leg, fixedBase).baseFit().judging);
  evaluator.leaveFloatingBaseOut(false);
  EXPECT_EQ(evaluator.baseFit().judging, whole);
  EXPECT_GT(evaluator.chi(1, 0), 100);
}

}  // namespace
}  // namespace plumbline::gap
