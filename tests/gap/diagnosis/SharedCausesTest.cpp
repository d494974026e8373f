#include "gap/diagnosis/SharedCauses.h"

#include <gtest/gtest.h>

#include "../TwoJointArm.h"

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

}  // namespace
}  // namespace plumbline::gap
