#include "gap/inference/JointValues.h"

#include <gtest/gtest.h>

#include "../ThreeMotions.h"

namespace plumbline::gap {

TEST(JointValues, aValueForAllJointsBecomesOneInEach) {
  const Mechanism arm = twoJointArm();
  const Groups groups(threeMotions(
      {causeOfArm("coulomb_friction", "shoulder", 0.15), causeOfArm("coulomb_friction", "elbow", 0.05)}));
  const Replayer replayer(arm, groups, 1);
  const Explanation shared{{findEffect("coulomb_friction"), {Site::everywhere, -1, "*"}, 0.1, 0}};
  const Explanation model = withJointValues(replayer, shared);
  ASSERT_EQ(model.size(), 2U);
  EXPECT_NEAR(causeIn(model, "coulomb_friction", "shoulder").value, 0.15, 0.008);
  EXPECT_NEAR(causeIn(model, "coulomb_friction", "elbow").value, 0.05, 0.004);
  EXPECT_LT(shareLeft(replayer, model), 0.1 * shareLeft(replayer, shared));
}

TEST(JointValues, aKindFoundInOneJointIsLookedForInTheOthers) {
  const Mechanism arm = twoJointArm();
  const Explanation truth{causeOfArm("viscous_friction", "shoulder", 0.2),
                          causeOfArm("viscous_friction", "elbow", 0.05)};
  const Groups groups(threeMotions(truth));
  const Explanation model = withJointValues(Replayer(arm, groups, 1), {truth[0]});
  EXPECT_NEAR(causeIn(model, "viscous_friction", "shoulder").value, 0.2, 0.01);
  EXPECT_NEAR(causeIn(model, "viscous_friction", "elbow").value, 0.05, 0.005);
}

TEST(JointValues, whatDoesNotSitAtJointsStaysAsItIs) {
  const Mechanism arm = twoJointArm();
  const Explanation mass{causeOfArm("link_mass", "lower", 0.05)};
  const Groups groups(threeMotions(mass));
  const Replayer replayer(arm, groups, 1);
  EXPECT_FALSE(differsByJoint(arm, mass));
  EXPECT_EQ(withJointValues(replayer, mass), mass);
  const Explanation both{mass[0], causeOfArm("coulomb_friction", "elbow", 0.05)};
  EXPECT_TRUE(differsByJoint(arm, both));
  EXPECT_EQ(withJointValues(replayer, both).front(), mass[0]);
}

TEST(JointValues, aRobotWithOneMotorHasNoOtherJoints) {
  Mechanism pendulum = twoJointArm();
  pendulum.joints.pop_back();
  pendulum.links.pop_back();
  const Cause friction = causeOf(pendulum, "coulomb_friction", "shoulder", 0.1);
  EXPECT_FALSE(differsByJoint(pendulum, {friction}));
}

TEST(JointValues, areSaidInALineForEachKind) {
  EXPECT_EQ(jointValuesText(
                {causeOfArm("coulomb_friction", "shoulder", 0.15), causeOfArm("link_mass", "lower", 0.05),
                 causeOfArm("coulomb_friction", "elbow", 0.05), causeOfArm("servo_gain", "elbow", 0.9)}),
            "  coulomb_friction in 2 joints: 0.05 to 0.15 N m\n  servo_gain in 1 joint: 0.9\n");
  EXPECT_EQ(jointValuesText({}), "");
}

}  // namespace plumbline::gap
