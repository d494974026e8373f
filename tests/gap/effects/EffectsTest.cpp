#include "gap/effects/Effects.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>

#include "../TwoJointArm.h"
#include "robot/MechanismFile.h"

namespace plumbline::gap {
namespace {

TEST(EffectsTest, theContractsLibraryAndWhatElseTheFieldHas) {
  const std::vector<std::string_view> expected{
      "command_delay", "command_dropout", "servo_gain", "servo_damping", "torque_limit", "speed_limit",
      "coulomb_friction", "viscous_friction", "stribeck_friction", "load_friction", "backlash",
      "joint_compliance", "acceleration_limit", "dead_band", "supply_voltage", "bias_force",
      "thermal_derating", "rotor_inertia", "joint_offset", "encoder_nonlinearity", "link_mass", "com_offset",
      "link_length", "imu_misalignment", "gyro_bias", "imu_delay", "fsr_gain", "ground_friction",
      "ground_slope", "ground_compliance", "external_force",
      // What the contract does not list comes behind it.
      "asymmetric_friction", "load_stribeck_friction", "link_load_friction", "quadratic_load_friction",
      "profile_speed", "supply_sag", "payload", "command_lag", "duty_limit"};
  std::vector<std::string_view> ids;
  for (const Effect* effect : effects()) ids.push_back(effect->id);
  EXPECT_EQ(ids, expected);
}

TEST(EffectsTest, eachCanBePutSomewhereAndChangesThePlant) {
  const Mechanism nao = findMechanism("nao_v5");
  for (const Effect* effect : effects()) {
    const auto places = placesOf(*effect, nao);
    ASSERT_FALSE(places.empty()) << effect->id;
    ASSERT_FALSE(effect->starts.empty()) << effect->id;
    for (const double start : effect->starts) {
      EXPECT_GE(start, effect->lower) << effect->id;
      EXPECT_LE(start, effect->upper) << effect->id;
      EXPECT_NE(start, effect->nominal) << effect->id;
    }
    EXPECT_FALSE(effect->sentence.empty());
    EXPECT_FALSE(effect->exposedBy.empty());
  }
}

TEST(EffectsTest, whatIsFittedInAllJointsKeepsItsOrder) {
  const std::vector<std::string_view> expected{"rotor_inertia",     "viscous_friction", "coulomb_friction",
                                               "stribeck_friction", "load_friction",    "servo_gain",
                                               "servo_damping",     "torque_limit",     "joint_offset",
                                               "bias_force",        "command_delay"};
  std::vector<std::string_view> ids;
  for (const Effect* effect : actuatorEffects()) ids.push_back(effect->id);
  EXPECT_EQ(ids, expected);
}

TEST(EffectsTest, lookAlikesAreInTheLibraryAndMutual) {
  int pairs = 0;
  for (const Effect* effect : effects()) {
    if (effect->alike.id.empty()) continue;
    const Effect* other = findEffect(effect->alike.id);
    ASSERT_TRUE(other) << effect->id;
    EXPECT_EQ(other->alike.id, effect->id);
    EXPECT_NE(other->alike.turn, effect->alike.turn);
    ++pairs;
  }
  EXPECT_EQ(pairs, 18);
}

TEST(EffectsTest, eachIsDrawnWithinWhatIsLookedFor) {
  for (const Effect* effect : effects()) {
    const DrawRange& drawing = effect->drawing;
    if (effect->id == "link_load_friction") continue;  // not looked for: a form of load_friction
    ASSERT_NE(drawing.where, DrawRange::Where::nowhere) << effect->id;
    EXPECT_LT(drawing.low, drawing.high) << effect->id;
    EXPECT_LE(drawing.low2, drawing.high2) << effect->id;
    EXPECT_EQ(effect->hasAxis, !drawing.axes.empty()) << effect->id;
    // A supply that has dropped is drawn lower than a fit looks for it.
    if (drawing.unit != DrawRange::Unit::plain || effect->id == "supply_voltage") continue;
    EXPECT_GE(drawing.low, effect->lower) << effect->id;
    EXPECT_LE(std::max(drawing.high, drawing.high2), effect->upper) << effect->id;
    if (drawing.bothSigns) {
      EXPECT_LE(effect->lower, -drawing.high) << effect->id;
    }
  }
}

TEST(EffectsTest, aDcMotorHasNoSpeedLimit) {
  const Effect& limit = *findEffect("speed_limit");
  const Mechanism nao = findMechanism("nao_v5"), pendulum = findMechanism("xl330_pendulum");
  EXPECT_TRUE(limit.canBeAt(nao, placesOf(limit, nao)[0]));
  EXPECT_FALSE(limit.canBeAt(pendulum, placesOf(limit, pendulum)[0]));
}

TEST(EffectsTest, servosOfOneTypeMayAllBeAlike) {
  const Effect& friction = *findEffect("coulomb_friction");
  Mechanism arm = twoJointArm();
  const Place all = findPlace(friction, arm, "*", "");
  EXPECT_EQ(all.site, Site::everywhere);
  EXPECT_EQ(friction.scaleAt(arm, all), arm.joints[0].maxTorque);
  Plant plant = nominalPlant(arm);
  friction.apply(plant, all, 0.1, 0);
  EXPECT_EQ(plant.joints[0].coulomb, 0.1);
  EXPECT_EQ(plant.joints[1].coulomb, 0.1);
  // Of motors of several types, and of one motor alone, it is said joint by joint.
  arm.joints[1].servo.kp += 1;
  EXPECT_THROW(findPlace(friction, arm, "*", ""), std::invalid_argument);
  EXPECT_THROW(findPlace(friction, findMechanism("nao_v5"), "*", ""), std::invalid_argument);
  EXPECT_THROW(findPlace(friction, findMechanism("xl330_pendulum"), "*", ""), std::invalid_argument);
}

TEST(EffectsTest, allJointsOfARobotWithOneMotorAreThatOne) {
  const Effect& delay = *findEffect("command_delay");
  const Mechanism pendulum = findMechanism("xl330_pendulum");
  ASSERT_EQ(placesOf(delay, pendulum).size(), 1u);
  EXPECT_EQ(placesOf(delay, pendulum)[0].at, "pendulum");
  EXPECT_EQ(findPlace(delay, pendulum, "*", "").at, "pendulum");
  EXPECT_EQ(findPlace(*findEffect("command_dropout"), pendulum, "*", "").at, "*");
  EXPECT_EQ(findPlace(delay, twoJointArm(), "*", "").at, "*");
}

TEST(EffectsTest, rangesAreForANaoAndGrowWithTheRobot) {
  const Mechanism nao = findMechanism("nao_v5"), so101 = findMechanism("so101");
  for (const char* id : {"link_mass", "com_offset", "rotor_inertia", "joint_compliance", "thermal_derating",
                         "external_force", "command_delay"}) {
    const Effect& effect = *findEffect(id);
    for (const Place& place : placesOf(effect, nao)) EXPECT_EQ(effect.scaleAt(nao, place), 1) << id;
  }
  Mechanism giant = twoJointArm();
  for (auto& link : giant.links) link.mass *= 50;
  for (auto& joint : giant.joints) {
    joint.origin *= 4;
    joint.maxTorque = 70;
    joint.servo.kp = 0.5;
  }
  const auto scale = [&](const char* id, const char* place, const char* axis) {
    return findEffect(id)->scaleAt(giant, findPlace(*findEffect(id), giant, place, axis));
  };
  EXPECT_NEAR(scale("link_mass", "lower", ""), 75 / 5.5, 1e-12);
  EXPECT_NEAR(scale("com_offset", "lower", "x"), 0.8 / 0.14, 1e-12);
  EXPECT_NEAR(scale("rotor_inertia", "elbow", ""), 20, 1e-12);
  EXPECT_NEAR(scale("joint_compliance", "elbow", ""), 10, 1e-12);
  EXPECT_NEAR(scale("thermal_derating", "elbow", ""), 1 / 400.0, 1e-12);
  EXPECT_NEAR(scale("thermal_derating", "*", ""), 1 / 400.0, 1e-12);
  const Effect& rotor = *findEffect("rotor_inertia");
  EXPECT_NEAR(rotor.scaleAt(so101, findPlace(rotor, so101, "Elbow", "")), 5.41, 0.001);
}

TEST(EffectsTest, anAccelerationLimitOf400IsOne) {
  const Effect& limit = *findEffect("acceleration_limit");
  EXPECT_NEAR(limit.strengthOf(400), 1 / 400.0 - 1 / 4000.0, 1e-15);
  EXPECT_NEAR(limit.valueAt(limit.strengthOf(400)), 400, 1e-9);
}

TEST(EffectsTest, nominalValueChangesNothing) {
  const Mechanism arm = twoJointArm();
  const Trial trial = armTrial(arm, 2);
  const auto plain = replay(nominalPlant(arm), trial).values;
  for (const Effect* effect : effects())
    for (const Place& place : placesOf(*effect, arm)) {
      if (effect->id == "acceleration_limit") continue;  // nominal is none; the largest limit stands for it
      Plant plant = nominalPlant(arm);
      effect->apply(plant, place, effect->nominal, 0);
      EXPECT_EQ(replay(plant, trial).values, plain) << effect->id << " at " << place.at;
    }
}

TEST(EffectsTest, jointsThatShareAMotorShareTheEffect) {
  const Mechanism nao = findMechanism("nao_v5");
  Plant plant = nominalPlant(nao);
  const Effect& friction = *findEffect("coulomb_friction");
  friction.apply(plant, findPlace(friction, nao, "LHipYawPitch", ""), 0.2, 0);
  EXPECT_EQ(plant.joints[static_cast<std::size_t>(nao.jointIndex("LHipYawPitch"))].coulomb, 0.2);
  EXPECT_EQ(plant.joints[static_cast<std::size_t>(nao.jointIndex("RHipYawPitch"))].coulomb, 0.2);
  EXPECT_EQ(plant.joints[static_cast<std::size_t>(nao.jointIndex("LHipRoll"))].coulomb, 0);
}

TEST(EffectsTest, linkLoadFrictionAloneIsAFormOfLoadFriction) {
  const Mechanism arm = twoJointArm();
  const Trial trial = armTrial(arm, 2);
  const Effect &link = *findEffect("link_load_friction"), &load = *findEffect("load_friction");
  const Place elbow = findPlace(link, arm, "elbow", "");
  EXPECT_FALSE(link.canBeAt(arm, elbow)) << "a search would have the same twice";
  Plant one = nominalPlant(arm), other = one;
  link.apply(one, elbow, 0.3, 0);
  load.apply(other, elbow, 0.3, 1);
  EXPECT_EQ(replay(one, trial).values, replay(other, trial).values);
}

TEST(EffectsTest, aWrongPlaceNamesThoseThereAre) {
  const Mechanism arm = twoJointArm();
  try {
    findPlace(*findEffect("backlash"), arm, "wrist", "");
    FAIL();
  } catch (const std::invalid_argument& error) {
    EXPECT_STREQ(error.what(), "backlash cannot be at 'wrist'; possible places: shoulder, elbow, *");
  }
  EXPECT_EQ(findEffect("gremlins"), nullptr);
}

}  // namespace
}  // namespace plumbline::gap
