#include "gap/diagnosis/GroupedCrossValidation.h"

#include <gtest/gtest.h>

#include "gap/TwoJointArm.h"

namespace plumbline::gap {
namespace {

class GroupedCrossValidationTest : public ::testing::Test {
protected:
  /// One recording per servo gain, all with these causes in them.
  static Evidence recordedWith(const Explanation& causes, const std::vector<double>& gains) {
    std::vector<Trial> trials;
    for (const double kp : gains) {
      Mechanism arm = twoJointArm();
      for (auto& joint : arm.joints) joint.servo.kp = kp;
      trials.push_back(recorded(plantOf(arm, causes), armTrial(arm, 1.5), 5e-4, 3));
    }
    return Evidence(trials);
  }

  /// Two motions of a soft arm with these causes in it, one recorded in two windows.
  std::vector<Trial> recordedIn(const Explanation& causes) const {
    Mechanism soft = arm;
    for (auto& joint : soft.joints) joint.servo.kp = 10;
    std::vector<Trial> trials;
    for (const char* motion : {"wide", "narrow", "narrow"}) {
      trials.push_back(
          recorded(plantOf(soft, causes), armTrial(soft, 3, *motion == 'w' ? 0.5 : 0.4), 5e-4, 3));
      trials.back().recordedMotion = motion;
      trials.back().motion += std::to_string(trials.size());
    }
    return trials;
  }

  const Mechanism arm = twoJointArm();
};

TEST_F(GroupedCrossValidationTest, oneSettingIsNotEnough) {
  EXPECT_FALSE(GroupedCrossValidation(arm, recordedWith({}, {20, 20}), 1).possible());
  EXPECT_TRUE(GroupedCrossValidation(arm, recordedWith({}, {20, 40}), 1).possible());
}

TEST_F(GroupedCrossValidationTest, motionsAreGroupsToo) {
  const Explanation truth = {causeOfArm("coulomb_friction", "elbow", 0.1),
                             causeOfArm("viscous_friction", "elbow", 0.15)};
  std::vector<Trial> trials = recordedIn(truth);
  EXPECT_FALSE(GroupedCrossValidation(arm, Evidence(trials), 1).possible());
  const auto motion = GroupedCrossValidation::Left::motion;
  const GroupedCrossValidation motions(arm, Evidence(trials), 1, {}, motion);
  ASSERT_TRUE(motions.possible());
  const GroupedCrossValidation::Tried tried = motions.of(truth);
  EXPECT_EQ(tried.perFold.size(), 2u) << "two segments of one recording are left out together";
  EXPECT_LT(tried.error, 0.1);
  EXPECT_GT(motions.of({truth[0]}).error, 3 * tried.error);
  trials.erase(trials.begin());
  EXPECT_FALSE(GroupedCrossValidation(arm, Evidence(trials), 1, {}, motion).possible());
}

TEST_F(GroupedCrossValidationTest, nothingPredictsWorseThanTheNominalModelAndTheTruthPredictsBest) {
  const Explanation truth = {causeOfArm("coulomb_friction", "elbow", 0.1),
                             causeOfArm("viscous_friction", "elbow", 0.15)};
  const GroupedCrossValidation settings(arm, recordedWith(truth, {10, 40}), 1);
  EXPECT_EQ(settings.of({}).error, 1);
  const GroupedCrossValidation::Tried tried = settings.of(truth);
  EXPECT_LT(tried.error, 0.1);
  EXPECT_NEAR(tried.causes[0].value, 0.1, 0.005);
  EXPECT_NEAR(tried.causes[1].value, 0.15, 0.01);
  EXPECT_GT(settings.of({causeOfArm("coulomb_friction", "elbow", 0.1)}).error, 3 * tried.error);
}

TEST_F(GroupedCrossValidationTest, thePairIsFoundThatHoldsUnderBothSettings) {
  const GroupedCrossValidation settings(arm,
                                        recordedWith({causeOfArm("coulomb_friction", "elbow", 0.1),
                                                      causeOfArm("viscous_friction", "elbow", 0.15)},
                                                     {10, 40}),
                                        1);
  std::vector<Cause> starts;
  for (const auto& [id, value] :
       {std::pair("coulomb_friction", 0.05), {"viscous_friction", 0.05}, {"servo_gain", 0.8}})
    starts.push_back(causeOfArm(id, "elbow", value));
  double done = 0;
  const GroupedCrossValidation::Tried best = settings.best(starts, 3, [&](double share) { done = share; });
  ASSERT_EQ(best.causes.size(), 2u);
  const std::size_t dry = best.causes[0].effect->id == "coulomb_friction" ? 0 : 1;
  EXPECT_EQ(best.causes[dry].effect->id, "coulomb_friction");
  EXPECT_EQ(best.causes[1 - dry].effect->id, "viscous_friction");
  EXPECT_NEAR(best.causes[dry].value, 0.1, 0.005);
  EXPECT_NEAR(best.causes[1 - dry].value, 0.15, 0.01);
  EXPECT_EQ(best.perFold.size(), 2u);
  EXPECT_GT(done, 0.5);
}

TEST_F(GroupedCrossValidationTest, theVariantIsTakenThatPredictsMotionsLeftOut) {
  Cause load = causeOfArm("load_friction", "shoulder", 0.3);
  load.variant = 1;
  const Evidence evidence(recordedIn({load}));
  const GroupedCrossValidation motions(arm, evidence, 1, {}, GroupedCrossValidation::Left::motion);
  const GroupedCrossValidation::Tried other = motions.of({causeOfArm("load_friction", "shoulder", 0.2)});
  const GroupedCrossValidation::Tried best = motions.withBestVariants(other);
  ASSERT_EQ(best.causes.size(), 1u);
  EXPECT_EQ(best.causes[0].variant, 1);
  EXPECT_NEAR(best.causes[0].value, 0.3, 0.01);
  EXPECT_LT(best.error, 0.5 * other.error);
  EXPECT_EQ(motions.withBestVariants(best).causes, best.causes);
}

TEST_F(GroupedCrossValidationTest, ofTwoSetsTheOneThatPredictsMotionsBetter) {
  Cause load = causeOfArm("load_friction", "shoulder", 0.3);
  load.variant = 1;
  const Explanation truth = {load, causeOfArm("viscous_friction", "elbow", 0.15)};
  const Evidence evidence(recordedIn(truth));
  Evaluator evaluator(arm, evidence);
  evaluator.setBase({});
  Explanation otherLaw = truth;
  otherLaw[0].variant = 0;
  const Explanation less = {truth[1]};
  const Explanation better = betterAcrossMotions(evaluator, otherLaw, less, 1);
  ASSERT_EQ(better.size(), 2u);
  EXPECT_EQ(better[0].variant, 1);
  EXPECT_NEAR(better[0].value, 0.3, 0.01);
  EXPECT_NEAR(better[1].value, 0.15, 0.01);
  EXPECT_EQ(betterAcrossMotions(evaluator, less, truth, 1), truth);

  std::vector<Trial> one = recordedIn(truth);
  one.erase(one.begin());
  const Evidence oneMotion(one);
  Evaluator judging(arm, oneMotion);
  judging.setBase({});
  EXPECT_EQ(betterAcrossMotions(judging, truth, less, 1), truth) << "the blocks for judging tell";
  EXPECT_EQ(betterAcrossMotions(judging, less, truth, 1), truth);
}

}  // namespace
}  // namespace plumbline::gap
