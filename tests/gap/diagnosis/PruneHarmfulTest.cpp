#include "gap/diagnosis/PruneHarmful.h"

#include <gtest/gtest.h>

#include "../TwoJointArm.h"
#include "gap/diagnosis/CauseSearch.h"

namespace plumbline::gap {
namespace {

/// Recordings of an arm whose elbow has dry friction of 0.08 N m, and a set of causes to be looked at.
struct PruneHarmfulTest : ::testing::Test {
  PruneHarmfulTest()
      : evidence(trials()), fine(arm, evidence), coarse(arm, evidence, coarseSteps()), meter(fine) {}

  static Cause dryFriction() { return causeOfArm("coulomb_friction", "elbow", 0.08); }
  static std::vector<Trial> trials() {
    const Plant reality = plantOf(twoJointArm(), {dryFriction()});
    std::vector<Trial> result;
    for (const std::uint64_t seed : {1, 2})
      result.push_back(recorded(reality, armTrial(twoJointArm(), 6), 5e-4, seed));
    return result;
  }
  double gapOf(const Explanation& causes) {
    fine.setBase(causes);
    return meter.under(fine);
  }
  static std::vector<FittedCause> choiceOf(const Explanation& causes) {
    std::vector<FittedCause> list;
    for (const Cause& cause : causes) list.push_back({.cause = cause, .fit = {}});
    return list;
  }
  bool leaveOut(double before) { return pruneHarmful(selection, fine, meter, before, 1); }

  const Mechanism arm = twoJointArm();
  const Evidence evidence;
  Evaluator fine, coarse;
  const GapMeter meter;
  const DiagnosisOptions options;
  ForwardSelection selection{fine, coarse, options};
  const double before = gapOf({});
  const Cause friction = dryFriction(), harmful = causeOfArm("bias_force", "elbow", 0.9),
              harmless = causeOfArm("bias_force", "shoulder", 1e-4);
};

TEST_F(PruneHarmfulTest, whatHelpsStaysAsItIs) {
  selection.causes = {friction};
  selection.choices = {choiceOf({friction, harmless})};
  EXPECT_FALSE(leaveOut(before));
  EXPECT_EQ(selection.causes, Explanation{friction});
  EXPECT_EQ(selection.choices[0].size(), 2u);
  EXPECT_EQ(fine.base(), selection.causes);
}

TEST_F(PruneHarmfulTest, whatWorsensGivesWayToWhatStoodForChoice) {
  selection.causes = {harmful};
  selection.choices = {choiceOf({harmful, harmless, friction})};
  ASSERT_GT(gapOf(selection.causes), 2 * before);
  EXPECT_TRUE(leaveOut(before));
  EXPECT_EQ(selection.causes, Explanation{friction});
  ASSERT_EQ(selection.choices.size(), 1u);
  ASSERT_EQ(selection.choices[0].size(), 2u);  // as they fit now; what was tried and harms is not among them
  EXPECT_EQ(selection.choices[0][0].cause, friction);
  EXPECT_NEAR(selection.choices[0][0].fit.judging, fine.baseFit().judging, 1e-6);
  EXPECT_LT(meter.under(fine), 0.2 * before);
}

TEST_F(PruneHarmfulTest, whatWorsensGoesAndTheRestStays) {
  selection.causes = {friction, harmful};
  selection.choices = {choiceOf({friction}), choiceOf({harmful})};
  EXPECT_TRUE(leaveOut(before));
  EXPECT_EQ(selection.causes, Explanation{friction});
  ASSERT_EQ(selection.choices.size(), 1u);
  EXPECT_EQ(selection.choices[0][0].cause, friction);
}

TEST_F(PruneHarmfulTest, nothingIsLeftWhereAllWorsens) {
  selection.causes = {harmful};
  selection.choices = {{}};
  EXPECT_TRUE(leaveOut(before));
  EXPECT_TRUE(selection.causes.empty());
  EXPECT_TRUE(selection.choices.empty());
  EXPECT_EQ(meter.under(fine), before);
}

}  // namespace
}  // namespace plumbline::gap
