#include "gap/inference/RuledOut.h"

#include <gtest/gtest.h>

#include "../LegOnItsFoot.h"
#include "../ThreeRecordings.h"
#include "gap/inference/Strengths.h"

namespace plumbline::gap {

namespace {

/// What recordings of the arm with these causes rule out of one kind.
struct RuledOutOfArm {
  RuledOutOfArm(const Explanation& causes, const Cause& kind)
      : groups(recordings(causes)), replayer(arm, groups, 1), ruledOut(replayer, {kind}) {}

  Mechanism arm = twoJointArm();
  Groups groups;
  Replayer replayer;
  RuledOut ruledOut;
};

}  // namespace

TEST(RuledOut, aStartThatWouldShowAndWhatIsStronger) {
  const Cause start = causeOfArm("coulomb_friction", "elbow", 0.1);
  const RuledOutOfArm arm({}, start);
  const RuledOut& ruledOut = arm.ruledOut;
  EXPECT_FALSE(ruledOut.startFor(start));
  EXPECT_FALSE(ruledOut.startFor(causeOfArm("coulomb_friction", "elbow", 0.4)));
  EXPECT_TRUE(ruledOut.startFor(causeOfArm("coulomb_friction", "elbow", 0.01)));
  EXPECT_TRUE(ruledOut.startFor(causeOfArm("coulomb_friction", "shoulder", 0.1)));
  for (const Cause& each : startsOf(twoJointArm(), start)) EXPECT_FALSE(ruledOut.startFor(each));
}

TEST(RuledOut, eachSignForItself) {
  // A force that is there speaks against its opposite, not against itself.
  const Cause force = causeOfArm("bias_force", "elbow", 0.3);
  const RuledOutOfArm arm({force}, force);
  EXPECT_TRUE(arm.ruledOut.startFor(force));
  EXPECT_FALSE(arm.ruledOut.startFor(causeOfArm("bias_force", "elbow", -1)));
}

TEST(RuledOut, aWeakerCauseThatWouldGainTakesTheStartsPlace) {
  const Cause force = causeOfArm("bias_force", "elbow", 0.02);
  const RuledOutOfArm arm({force}, force);
  const std::optional<Cause> other = arm.ruledOut.startFor(causeOfArm("bias_force", "elbow", 1));
  ASSERT_TRUE(other);
  EXPECT_NEAR(other->value, 0.02, 0.01);
  EXPECT_FALSE(arm.ruledOut.startFor(causeOfArm("bias_force", "elbow", -1)));
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
