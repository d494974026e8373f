// A servo's profile, a supply that sags and what links carry, against what follows by hand.
#include <gtest/gtest.h>

#include "../OneJoint.h"

namespace plumbline::gap {
namespace {

using one::inertia;
using one::kd;
using one::kp;

TEST(ServoAndLoadTest, profileSpeedLetsTheGoalMoveAtThatSpeed) {
  const Mechanism robot = oneJoint();
  const Trial trial = oneJointTrial(robot, 3, [](double t) { return t < 0.495 ? 0.0 : 2.0; });
  const Prediction p = replay(plantWith(robot, "profile_speed", "joint", 1.5), trial);
  // The servo follows a ramp that began at 0.5 s with the lag of its damping.
  EXPECT_NEAR(p.values[0][150], 1.5 - 1.5 * kd / kp, 2e-3);
  EXPECT_NEAR(p.values[1][150], 1.5, 2e-3);
  EXPECT_NEAR(p.values[0][180], 1.5 * 1.3 - 1.5 * kd / kp, 2e-3);
  EXPECT_NEAR(p.values[0].back(), 2, 1e-4);
}

TEST(ServoAndLoadTest, aCommandSlowerThanTheProfileIsFollowed) {
  const Mechanism robot = oneJoint();
  const Trial trial = oneJointTrial(robot, 2, [](double t) { return 0.5 * t; });
  const auto with = replay(plantWith(robot, "profile_speed", "joint", 60), trial).values,
             without = replay(nominalPlant(robot), trial).values;
  // It takes 0.005 rad / 60 rad/s for each cycle's way: behind by half of that in the mean.
  for (std::size_t k = 100; k < trial.cycles(); ++k)
    ASSERT_NEAR(without[0][k] - with[0][k], 0.5 * 0.005 / 60 / 2, 1e-6);
}

TEST(ServoAndLoadTest, profilesOfSpeedAndAccelerationMakeATrapezoid) {
  const Mechanism robot = oneJoint();
  const Trial trial = oneJointTrial(robot, 3, [](double t) { return t < 0.495 ? 0.0 : 2.0; });
  Plant plant = nominalPlant(robot);
  plant.joints[0].profileSpeed = 2;
  plant.joints[0].accelerationLimit = 10;
  const Prediction p = replay(plant, trial);
  // Speeds up over 0.2 s and 0.2 rad, slows down likewise; 1.6 rad at 2 rad/s between.
  EXPECT_NEAR(p.values[1][120], 2, 5e-3);
  EXPECT_NEAR(p.values[0][120], 2 * 0.7 - 0.2 - 2 * kd / kp, 4e-3);
  EXPECT_NEAR(p.values[0].back(), 2, 1e-3);
}

TEST(ServoAndLoadTest, aServoThatIsShortOfDutyLosesItsBackEmfAndHasNoOtherLimit) {
  Mechanism robot = oneJoint();
  robot.joints[0].maxTorque = 0.5;
  const Trial trial = oneJointTrial(robot, 3, [](double t) { return t < 0.495 ? 0.0 : 50.0; });
  const Prediction p = replay(plantWith(robot, "duty_limit", "joint", 0.8), trial);
  // inertia dw/dt = 0.8 - kd w from the step on.
  const double time = inertia / kd;
  for (const double after : {0.1, 0.5, 2.0}) {
    const auto k = static_cast<std::size_t>(std::lround(100 * (0.5 + after)));
    EXPECT_NEAR(p.values[1][k], 0.8 / kd * (1 - std::exp(-after / time)), 0.02 * 0.8 / kd);
  }
}

TEST(ServoAndLoadTest, belowFullDutyItIsTheSameServo) {
  const Mechanism robot = oneJoint();
  const Trial trial = oneJointTrial(robot, 2, [](double t) { return 0.05 * std::sin(6 * t); });
  const auto with = replay(plantWith(robot, "duty_limit", "joint", 2), trial).values,
             nominal = replay(nominalPlant(robot), trial).values;
  for (std::size_t k = 0; k < trial.cycles(); ++k) ASSERT_NEAR(with[0][k], nominal[0][k], 1e-9);
}

TEST(ServoAndLoadTest, aSaggingSupplyHasTheTorqueThatItsOwnLoadLeaves) {
  Mechanism robot = oneJoint();
  robot.joints[0].maxTorque = 0.5;
  const Trial trial = oneJointTrial(robot, 1, [](double t) { return t < 0.495 ? 0.0 : 50.0; });
  const Prediction p = replay(plantWith(robot, "supply_sag", "*", 1), trial);
  // T = 0.5 (1 - 1 T / 0.5): half of it.
  EXPECT_NEAR((p.values[1][80] - p.values[1][60]) / 0.2, 0.25 / inertia, 0.02);
  const Prediction stiff = replay(nominalPlant(robot), trial);
  EXPECT_NEAR((stiff.values[1][80] - stiff.values[1][60]) / 0.2, 0.5 / inertia, 0.02);
}

TEST(ServoAndLoadTest, chainsOfAFixedBaseFeelEachOtherThroughTheSupply) {
  // Two arms on one base.
  Mechanism robot = twoJointArm();
  robot.joints[1].parent = 0;
  robot.joints[1].origin = Vec3(0, 0.3, 0.5);
  robot.links[2].parent = 0;
  const Trial trial = armTrial(robot, 3, 1.5);
  const Plant plant = plantWith(robot, "supply_sag", "*", 2);
  const auto whole = replay(plant, trial).values;
  ReplayOptions one;
  one.joints = {0};
  const auto apart = replay(plant, trial, one).values;
  EXPECT_EQ(apart[0], whole[0]);
  EXPECT_TRUE(apart[1].empty());
  EXPECT_NE(whole[0], replay(nominalPlant(robot), trial).values[0]);
  // What is at the other chain does not matter to this one's replay.
  Plant other = plant;
  other.joints[1].viscous += 0.5;
  EXPECT_EQ(replay(other, trial, one).values[0], apart[0]);
}

TEST(ServoAndLoadTest, aPayloadChangesMassPlaceAndInertiaTogether) {
  const Mechanism arm = twoJointArm();
  const auto aboutJoint = [](const Mechanism::Link& link) {
    return Mat3(link.inertia +
                link.mass * (link.com.squaredNorm() * Mat3::Identity() - link.com * link.com.transpose()));
  };
  const auto& nominal = arm.links[2];
  // The last link ends as far behind its centre of mass as that is from the joint.
  for (const auto& [variant, out] : {std::pair{0, 0.4}, std::pair{1, 0.6}}) {
    const Mechanism::Link loaded = plantWith(arm, "payload", "lower", 0.1, variant).mechanism.links[2];
    EXPECT_DOUBLE_EQ(loaded.mass, 0.3);
    EXPECT_NEAR(loaded.mass * loaded.com.z(), nominal.mass * nominal.com.z() - 0.1 * out, 1e-12);
    const Mat3 more = aboutJoint(loaded) - aboutJoint(nominal);
    EXPECT_NEAR(more(0, 0), 0.1 * out * out, 1e-12);
    EXPECT_NEAR(more(1, 1), 0.1 * out * out, 1e-12);
    EXPECT_NEAR(more(2, 2), 0, 1e-12);
  }
  // The upper one ends at the elbow.
  const Mechanism::Link upper = plantWith(arm, "payload", "upper", 0.1).mechanism.links[1];
  EXPECT_NEAR(upper.mass * upper.com.z(), -0.3 * 0.2 - 0.1 * 0.2, 1e-12);
}

TEST(ServoAndLoadTest, aGroupOfJointsSharesAServosEffect) {
  Mechanism arm = twoJointArm();
  arm.joints[1].servo.kp += 1;  // no longer of one type
  arm.joints[1].maxTorque = 2;
  const Effect& friction = *findEffect("coulomb_friction");
  EXPECT_THROW(findPlace(friction, arm, "both", ""), std::invalid_argument);
  arm.groups = {{"both", {0, 1}}, {"distal", {1}}};
  const Place both = findPlace(friction, arm, "both", ""), distal = findPlace(friction, arm, "distal", "");
  Plant plant = nominalPlant(arm);
  friction.apply(plant, both, 0.1, 0);
  friction.apply(plant, distal, 0.05, 0);
  EXPECT_DOUBLE_EQ(plant.joints[0].coulomb, 0.1);
  EXPECT_DOUBLE_EQ(plant.joints[1].coulomb, 0.15);
  EXPECT_EQ(friction.scaleAt(arm, both), 3);
  EXPECT_EQ(friction.scaleAt(arm, distal), 2);
  // What is no servo's has no groups.
  EXPECT_THROW(findPlace(*findEffect("bias_force"), arm, "both", ""), std::invalid_argument);
}

}  // namespace
}  // namespace plumbline::gap
