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

}  // namespace
}  // namespace plumbline::gap
