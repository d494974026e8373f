#include "gap/inference/RuledOut.h"

#include <gtest/gtest.h>

#include "../LegOnItsFoot.h"
#include "../ThreeRecordings.h"
#include "gap/inference/PossibleKinds.h"

namespace plumbline::gap {

TEST(RuledOut, aStartThatWouldShowAndWhatIsStronger) {
  const Mechanism arm = twoJointArm();
  const Groups groups(recordings({}));
  const Replayer replayer(arm, groups, 1);
  const Cause start = causeOfArm("coulomb_friction", "elbow", 0.1);
  const RuledOut ruledOut(replayer, {start});
  EXPECT_FALSE(ruledOut.startFor(start));
  EXPECT_FALSE(ruledOut.startFor(causeOfArm("coulomb_friction", "elbow", 0.4)));
  EXPECT_TRUE(ruledOut.startFor(causeOfArm("coulomb_friction", "elbow", 0.01)));
  EXPECT_TRUE(ruledOut.startFor(causeOfArm("coulomb_friction", "shoulder", 0.1)));
  EXPECT_EQ(ruledOut.numWithoutStart(), 1U);
}

TEST(RuledOut, eachSignForItself) {
  // A force that is there speaks against its opposite, not against itself.
  const Mechanism arm = twoJointArm();
  const Groups groups(recordings({causeOfArm("bias_force", "elbow", 0.3)}));
  const Replayer replayer(arm, groups, 1);
  const RuledOut ruledOut(replayer, {causeOfArm("bias_force", "elbow", 0.3)});
  EXPECT_TRUE(ruledOut.startFor(causeOfArm("bias_force", "elbow", 0.3)));
  EXPECT_FALSE(ruledOut.startFor(causeOfArm("bias_force", "elbow", -1)));
  EXPECT_EQ(ruledOut.numWithoutStart(), 0U);
}

TEST(RuledOut, aWeakerCauseThatWouldGainTakesTheStartsPlace) {
  const Mechanism arm = twoJointArm();
  const Groups groups(recordings({causeOfArm("bias_force", "elbow", 0.02)}));
  const Replayer replayer(arm, groups, 1);
  const RuledOut ruledOut(replayer, {causeOfArm("bias_force", "elbow", 0.1)});
  const std::optional<Cause> other = ruledOut.startFor(causeOfArm("bias_force", "elbow", 1));
  ASSERT_TRUE(other);
  EXPECT_NEAR(other->value, 0.02, 0.01);
  EXPECT_FALSE(ruledOut.startFor(causeOfArm("bias_force", "elbow", -1)));
  EXPECT_EQ(ruledOut.numWithoutStart(), 0U);
}

TEST(RuledOut, notWhatTheRobotHasAlready) {
  // With the force as base, more of it is ruled out.
  const Mechanism arm = twoJointArm();
  const Cause force = causeOfArm("bias_force", "elbow", 0.3);
  const Groups groups(recordings({force}));
  const Replayer nominal(arm, groups, 1);
  const Replayer replayer(nominal, groups, {force});
  const RuledOut ruledOut(replayer, {causeOfArm("viscous_friction", "elbow", 0.1)});
  EXPECT_FALSE(ruledOut.startFor(causeOfArm("viscous_friction", "elbow", 0.4)));
}

TEST(RuledOut, whatAFixedBaseDoesNotFeelIsNot) {
  const Mechanism leg = legOnItsFoot();
  Trial trial = recorded(plantOf(leg, {}), legTrial(false), 5e-4, 3);
  const Groups groups({trial});
  const Replayer replayer(leg, groups, 1);
  const Cause body = causeOf(leg, "link_mass", "base", 0.3), link = causeOf(leg, "link_mass", "lower", 0.1);
  const RuledOut ruledOut(replayer, {body, link});
  EXPECT_TRUE(ruledOut.startFor(body));
  EXPECT_FALSE(ruledOut.startFor(link));
}

}  // namespace plumbline::gap
