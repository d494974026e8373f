#include "gap/diagnosis/SharedCauses.h"

#include <gtest/gtest.h>

#include "../TwoJointArm.h"
#include "gap/diagnosis/Diagnosis.h"
#include "gap/diagnosis/Search.h"

namespace plumbline::gap {
namespace {

/// A recording of the arm with a change in it; the reality takes other, finer steps.
Evidence evidenceOf(const Mechanism& arm, const std::function<void(Plant&)>& change) {
  Plant reality = nominalPlant(arm);
  change(reality);
  ReplayOptions fineSteps;
  fineSteps.step = fineSteps.gearStep = 0.0003;
  std::vector<Trial> trials;
  trials.push_back(recorded(reality, armTrial(arm, 3), 5e-4, 11, fineSteps));
  return Evidence(std::move(trials));
}

double valueOf(const Explanation& causes, std::string_view id) {
  for (const Cause& cause : causes)
    if (cause.effect->id == id && cause.place.site == Site::everywhere) return cause.value;
  return NAN;
}

/// Soft servos with dry friction.
void softAndDry(Plant& plant) {
  for (JointPlant& joint : plant.joints) joint.servo.kp *= 0.8, joint.coulomb = 0.2;
}

/// And a limit of the last joint that shows more than both.
void softDryAndLimited(Plant& plant) {
  softAndDry(plant);
  plant.joints.back().accelerationLimit = 20;
}

class SharedCausesTest : public ::testing::Test {
protected:
  const Mechanism arm = twoJointArm();
};

TEST_F(SharedCausesTest, twoAreFoundWithTheirValues) {
  std::vector<double> told;
  const Explanation found =
      sharedCauses(arm, evidenceOf(arm, softAndDry), 3, 1, [&](double share) { told.push_back(share); });
  EXPECT_NEAR(valueOf(found, "servo_gain"), 0.8, 0.05);
  EXPECT_NEAR(valueOf(found, "coulomb_friction"), 0.2, 0.06);
  ASSERT_FALSE(told.empty());
  EXPECT_TRUE(std::ranges::is_sorted(told));
  EXPECT_DOUBLE_EQ(told.back(), 1);
}

TEST_F(SharedCausesTest, oneAloneIsNoSet) {
  const auto soft = [](Plant& plant) {
    for (JointPlant& joint : plant.joints) joint.servo.kp *= 0.75;
  };
  EXPECT_TRUE(sharedCauses(arm, evidenceOf(arm, soft), 3, 1).empty());
}

TEST_F(SharedCausesTest, noneWhereOnlyOneIsAllowed) {
  EXPECT_TRUE(sharedCauses(arm, evidenceOf(arm, softAndDry), 1, 1).empty());
}

TEST_F(SharedCausesTest, aDiagnosisFindsTheOddJointToo) {
  const Evidence evidence = evidenceOf(arm, softDryAndLimited);
  Evaluator fine(arm, evidence), coarse(arm, evidence, coarseSteps());
  const Diagnosis diagnosis = diagnose(fine, coarse, {});
  const Explanation found = diagnosis.explanation();
  EXPECT_EQ(diagnosis.verdict, Verdict::effect);
  EXPECT_EQ(found.size(), 3u);
  EXPECT_NEAR(valueOf(found, "servo_gain"), 0.8, 0.02);
  EXPECT_NEAR(valueOf(found, "coulomb_friction"), 0.2, 0.02);
  EXPECT_TRUE(std::ranges::any_of(found, [](const Cause& cause) {
    return cause.effect->id == "acceleration_limit" && cause.place.at == "elbow";
  }));
}

}  // namespace
}  // namespace plumbline::gap
