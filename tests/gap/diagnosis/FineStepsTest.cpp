#include "gap/diagnosis/FineSteps.h"

#include <gtest/gtest.h>

#include "../TwoJointArm.h"

namespace plumbline::gap {
namespace {

ReplayOptions stepsOf(const Mechanism& arm, double noise) {
  return fineSteps(Evidence({recorded(nominalPlant(arm), armTrial(arm, 6), noise, 3)}), 1);
}

TEST(FineStepsTest, areTheReplaysOwnWhereThoseAreConverged) {
  const ReplayOptions steps = stepsOf(twoJointArm(), 5e-4);
  EXPECT_EQ(steps.step, 0.002);
  EXPECT_EQ(steps.gearStep, 0.001);
}

TEST(FineStepsTest, areShorterForAStifferServo) {
  Mechanism arm = twoJointArm();
  for (Mechanism::Joint& joint : arm.joints) {
    joint.servo.kp = 400;
    joint.servo.kd = 3;
    joint.maxTorque = 30;
  }
  const ReplayOptions steps = stepsOf(arm, 5e-4);
  EXPECT_LT(steps.step, 0.002);
  EXPECT_EQ(steps.gearStep, steps.step / 2);
}

TEST(FineStepsTest, endAtAnEighth) {
  const Mechanism arm = twoJointArm();
  const Evidence evidence({recorded(nominalPlant(arm), armTrial(arm, 6), 0, 3)},
                          {{{1e-9, 1e-9}, {1e-9, 1e-9}}});
  EXPECT_EQ(fineSteps(evidence, 1).step, 0.002 / 8);
}

}  // namespace
}  // namespace plumbline::gap
