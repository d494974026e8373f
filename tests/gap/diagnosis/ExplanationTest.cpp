#include "gap/diagnosis/Explanation.h"

#include <gtest/gtest.h>

#include "../TwoJointArm.h"

namespace plumbline::gap {
namespace {

TEST(ExplanationTest, valuesNextToNominalDoNothing) {
  const Mechanism arm = twoJointArm();
  const auto nothing = [&](const char* id, double value) {
    return doesNothing(arm, causeOfArm(id, "elbow", value));
  };
  EXPECT_TRUE(nothing("joint_compliance", 2.4e-12));
  EXPECT_FALSE(nothing("joint_compliance", 1e-4));
  EXPECT_TRUE(nothing("backlash", 2e-18));
  EXPECT_TRUE(nothing("servo_gain", 1.00001));
  EXPECT_FALSE(nothing("servo_gain", 0.99));
  EXPECT_FALSE(nothing("speed_limit", 0.9));
}

TEST(ExplanationTest, whatWasNotSetInARecordingIsNotInItsPlant) {
  const Mechanism arm = twoJointArm();
  Trial trial = armTrial(arm, 1);
  trial.recording = "runs/tuesday/";
  Explanation causes = {causeOfArm("acceleration_limit", "elbow", 20),
                        causeOfArm("coulomb_friction", "elbow", 0.1)};
  EXPECT_EQ(plantOf(trial, causes).joints[1].accelerationLimit, 20);
  EXPECT_EQ(describeInactiveIn(causes[0]), "");
  causes[0].inactiveIn = {"runs/monday", "runs/tuesday/"};
  EXPECT_FALSE(inForce(causes[0], trial));
  EXPECT_EQ(plantOf(trial, causes).joints[1].accelerationLimit, 0);
  EXPECT_EQ(plantOf(trial, causes).joints[1].coulomb, 0.1);
  EXPECT_EQ(plantOf(arm, causes).joints[1].accelerationLimit, 20);
  EXPECT_EQ(describeInactiveIn(causes[0]), "not set in monday, tuesday");
}

}  // namespace
}  // namespace plumbline::gap
