#include "gap/diagnosis/SharedCauses.h"

#include <gtest/gtest.h>

#include "gap/TwoJointArm.h"

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
  Explanation found(const std::function<void(Plant&)>& change, std::size_t maxCauses,
                    const std::function<void(double)>& progress = {}) const {
    const Evidence evidence = evidenceOf(arm, change);
    Evaluator nominal(arm, evidence);
    nominal.setBase({});
    return sharedCauses(nominal, maxCauses, 1, progress);
  }

  const Mechanism arm = twoJointArm();
};

TEST_F(SharedCausesTest, twoAreFoundWithTheirValues) {
  std::vector<double> shares;
  const Explanation set = found(softAndDry, 3, [&](double share) { shares.push_back(share); });
  EXPECT_NEAR(valueOf(set, "servo_gain"), 0.8, 0.05);
  EXPECT_NEAR(valueOf(set, "coulomb_friction"), 0.2, 0.06);
  ASSERT_FALSE(shares.empty());
  EXPECT_TRUE(std::ranges::is_sorted(shares));
  EXPECT_DOUBLE_EQ(shares.back(), 1);
}

TEST_F(SharedCausesTest, oneAloneIsNoSet) {
  const auto soft = [](Plant& plant) {
    for (JointPlant& joint : plant.joints) joint.servo.kp *= 0.75;
  };
  EXPECT_TRUE(found(soft, 3).empty());
}

TEST_F(SharedCausesTest, noneWhereOnlyOneIsAllowed) { EXPECT_TRUE(found(softAndDry, 1).empty()); }

}  // namespace
}  // namespace plumbline::gap
