#include "gap/diagnosis/AcrossSettings.h"

#include <gtest/gtest.h>

#include "../TwoJointArm.h"

namespace plumbline::gap {
namespace {

class AcrossSettingsTest : public ::testing::Test {
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

  const Mechanism arm = twoJointArm();
};

TEST_F(AcrossSettingsTest, oneSettingIsNotEnough) {
  EXPECT_FALSE(AcrossSettings(arm, recordedWith({}, {20, 20}), 1).possible());
  EXPECT_TRUE(AcrossSettings(arm, recordedWith({}, {20, 40}), 1).possible());
}

TEST_F(AcrossSettingsTest, motionsAreGroupsToo) {
  const Explanation truth = {causeOfArm("coulomb_friction", "elbow", 0.1),
                             causeOfArm("viscous_friction", "elbow", 0.15)};
  Mechanism soft = arm;
  for (auto& joint : soft.joints) joint.servo.kp = 10;
  std::vector<Trial> trials;
  for (const char* motion : {"wide", "narrow", "narrow"}) {
    trials.push_back(recorded(plantOf(soft, truth), armTrial(soft, 3, *motion == 'w' ? 0.5 : 0.4), 5e-4, 3));
    trials.back().recordedMotion = motion;
    trials.back().motion += std::to_string(trials.size());
  }
  EXPECT_FALSE(AcrossSettings(arm, Evidence(trials), 1).possible());
  const auto motion = AcrossSettings::Left::motion;
  const AcrossSettings motions(arm, Evidence(trials), 1, {}, motion);
  ASSERT_TRUE(motions.possible());
  const AcrossSettings::Tried tried = motions.of(truth);
  EXPECT_EQ(tried.perFold.size(), 2u) << "two windows of one recording are left out together";
  EXPECT_LT(tried.error, 0.1);
  EXPECT_GT(motions.of({truth[0]}).error, 3 * tried.error);
  trials.erase(trials.begin());
  EXPECT_FALSE(AcrossSettings(arm, Evidence(trials), 1, {}, motion).possible());
}

TEST_F(AcrossSettingsTest, nothingPredictsWorseThanTheNominalModelAndTheTruthPredictsBest) {
  const Explanation truth = {causeOfArm("coulomb_friction", "elbow", 0.1),
                             causeOfArm("viscous_friction", "elbow", 0.15)};
  const AcrossSettings settings(arm, recordedWith(truth, {10, 40}), 1);
  EXPECT_EQ(settings.of({}).error, 1);
  const AcrossSettings::Tried tried = settings.of(truth);
  EXPECT_LT(tried.error, 0.1);
  EXPECT_NEAR(tried.causes[0].value, 0.1, 0.005);
  EXPECT_NEAR(tried.causes[1].value, 0.15, 0.01);
  EXPECT_GT(settings.of({causeOfArm("coulomb_friction", "elbow", 0.1)}).error, 3 * tried.error);
}

TEST_F(AcrossSettingsTest, thePairIsFoundThatHoldsUnderBothSettings) {
  const AcrossSettings settings(arm,
                                recordedWith({causeOfArm("coulomb_friction", "elbow", 0.1),
                                              causeOfArm("viscous_friction", "elbow", 0.15)},
                                             {10, 40}),
                                1);
  std::vector<Cause> starts;
  for (const auto& [id, value] :
       {std::pair("coulomb_friction", 0.05), {"viscous_friction", 0.05}, {"servo_gain", 0.8}})
    starts.push_back(causeOfArm(id, "elbow", value));
  double done = 0;
  const AcrossSettings::Tried best = settings.best(starts, 3, [&](double share) { done = share; });
  ASSERT_EQ(best.causes.size(), 2u);
  const std::size_t dry = best.causes[0].effect->id == "coulomb_friction" ? 0 : 1;
  EXPECT_EQ(best.causes[dry].effect->id, "coulomb_friction");
  EXPECT_EQ(best.causes[1 - dry].effect->id, "viscous_friction");
  EXPECT_NEAR(best.causes[dry].value, 0.1, 0.005);
  EXPECT_NEAR(best.causes[1 - dry].value, 0.15, 0.01);
  EXPECT_EQ(best.perFold.size(), 2u);
  EXPECT_GT(done, 0.5);
}

}  // namespace
}  // namespace plumbline::gap
