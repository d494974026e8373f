#include "gap/diagnosis/PossibleCauses.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "../LegOnItsFoot.h"
#include "gap/diagnosis/DeviatingJoints.h"
#include "gap/diagnosis/UnderLoad.h"

namespace plumbline::gap {
namespace {

class PossibleCausesTest : public ::testing::Test {
protected:
  Cause at(const char* id, const char* place, double value) const {
    const Effect* effect = findEffect(id);
    return {effect, findPlace(*effect, arm, place, ""), value, 0};
  }
  /// The variants of an effect at a place that are worth a look, a bit each.
  unsigned variants(const char* id, const char* place) const {
    const Cause wanted = at(id, place, 0);
    unsigned found = 0;
    for (const Cause& cause : possibleCauses(evaluator))
      if (cause.sameKind(wanted)) found |= 1u << static_cast<unsigned>(cause.variant);
    return found;
  }

  const Mechanism arm = twoJointArm();
  Plant plant = [this] {
    Plant p = nominalPlant(arm);
    p.joints[0].viscous += 0.5;
    p.joints[1].viscous += 0.5;
    return p;
  }();
  const Evidence evidence{{recorded(plant, armTrial(arm, 6), 5e-4, 3)}};
  Evaluator evaluator{arm, evidence};
};

TEST_F(PossibleCausesTest, aJointWithACauseHasNoLimitCycleAsWell) {
  evaluator.setBase({});
  EXPECT_EQ(variants("backlash", "shoulder"), 3u);
  EXPECT_EQ(variants("backlash", "elbow"), 3u);
  evaluator.setBase({at("viscous_friction", "elbow", 0.3)});
  EXPECT_EQ(variants("backlash", "shoulder"), 3u);
  EXPECT_EQ(variants("backlash", "elbow"), 1u) << "the encoder where the model has it";
}

TEST_F(PossibleCausesTest, noCauseTwiceAtAPlace) {
  evaluator.setBase({at("viscous_friction", "elbow", 0.3)});
  EXPECT_EQ(variants("viscous_friction", "elbow"), 0u);
  EXPECT_EQ(variants("viscous_friction", "shoulder"), 1u);
}

TEST_F(PossibleCausesTest, lostCommandsAreDecodedNotSearchedFor) {
  // Cycles decoded before, as others stood in the base, would make any share of them look like a cause.
  evaluator.setLostCycles({std::vector<std::uint8_t>(600, 1)});
  evaluator.setBase({});
  EXPECT_EQ(variants("command_dropout", "*"), 0u);
  EXPECT_EQ(variants("command_delay", "*"), 1u);
}

TEST(PossibleCausesOfJoints, whatDrivesTheWorstJointIsLookedAtThoughItIsFarLessOff) {
  Mechanism arm = twoJointArm();
  arm.joints[1].driver = 0;
  Trial trial = recorded(nominalPlant(arm), armTrial(arm, 6), 5e-4, 3);
  for (double& value : trial.signals[0].values) value += 0.002;
  for (double& value : trial.signals[1].values) value += 0.1;
  const Evidence evidence({trial});
  const Evaluator evaluator(arm, evidence);
  EXPECT_LT(jointExcess(evaluator, false)[0], 0.01 * jointExcess(evaluator, false)[1]);
  const DeviatingJoints suspects(evaluator);
  EXPECT_TRUE(suspects.joint[0]);
  arm.joints[1].driver = -1;
  const Evaluator undriven(arm, evidence);
  EXPECT_FALSE(DeviatingJoints(undriven).joint[0]);
}

TEST(PossibleCausesOfJoints, aJointThatWasNotSeenIsLookedAtWhereItsNeighbourIsOff) {
  const Mechanism arm = twoJointArm();
  Trial trial = recorded(nominalPlant(arm), armTrial(arm, 6), 5e-4, 3);
  for (double& value : trial.signals[0].values) value += 0.1;
  trial.signals.pop_back();
  const Evidence evidence({trial});
  const Evaluator evaluator(arm, evidence);
  const DeviatingJoints suspects(evaluator);
  EXPECT_TRUE(suspects.joint[0]);
  EXPECT_TRUE(suspects.joint[1]);
}

/// A leg that is clean where it hangs; on its foot the hip is off by an angle.
bool lookedForOnFeet(double offset, const char* id, const char* place) {
  const Mechanism leg = legOnItsFoot();
  std::vector<Trial> trials;
  for (const bool floatingBase : {false, true})
    trials.push_back(recorded(nominalPlant(leg), legTrial(floatingBase), 5e-4, 3));
  for (double& value : trials[1].signals[0].values) value += offset;
  const Evidence evidence(trials);
  const Evaluator evaluator(leg, evidence);
  const Effect* effect = findEffect(id);
  const Cause wanted{effect, findPlace(*effect, leg, place, ""), 0, 0};
  const std::vector<Cause> causes = possibleCauses(evaluator);
  const bool listed = std::ranges::any_of(causes, [&](const Cause& cause) { return cause.sameKind(wanted); });
  EXPECT_EQ(listed, UnderLoad(evaluator).shows(*effect, wanted.place)) << id << " at " << place;
  return listed;
}

TEST(PossibleCausesOnFeetTest, aLegThatIsCleanWhereItHangsMayBeOffUnderLoad) {
  EXPECT_TRUE(lookedForOnFeet(0.02, "link_length", "lower"));
  EXPECT_TRUE(lookedForOnFeet(0.02, "joint_offset", "knee"));
  EXPECT_TRUE(lookedForOnFeet(0.02, "torque_limit", "hip"));
  EXPECT_FALSE(lookedForOnFeet(0.02, "torque_limit", "knee")) << "the knee is where it should be";
  EXPECT_FALSE(lookedForOnFeet(0.02, "viscous_friction", "hip")) << "runs with a fixed base show that better";
  EXPECT_FALSE(lookedForOnFeet(0, "link_length", "lower"));
}

TEST(PossibleCausesOnFeetTest, ofARobotThatStepsTheDrivesOfWhatIsOff) {
  const Mechanism leg = legOnItsFoot();
  Trial trial = legTrial(true);
  const Prediction nominal = replay(nominalPlant(leg), trial);
  for (std::size_t s = 0; s < trial.signals.size(); ++s)
    for (std::size_t k = 0; k < trial.cycles(); ++k)
      trial.signals[s].values[k] = nominal.values[s][k] + (s == 1 && k % 2 ? 0.05 : 0);
  const auto looksFor = [&](const Trial& run, const char* id, const char* place) {
    const Evidence evidence({run}, {{{1e-3, 1e-3, false}, {1e-3, 1e-3, false}}});
    Evaluator evaluator(leg, evidence);
    evaluator.setBase({});
    const Effect* effect = findEffect(id);
    const Cause wanted{effect, findPlace(*effect, leg, place, ""), 0, 0};
    return std::ranges::any_of(possibleCauses(evaluator), [&](const Cause& c) { return c.sameKind(wanted); });
  };
  EXPECT_TRUE(looksFor(trial, "servo_gain", "hip")) << "in one piece, where it sways as a whole";
  Trial stepping = trial;
  stepping.restarts.push_back({2, {NAN, NAN}, {NAN, NAN}, {}});
  EXPECT_TRUE(looksFor(stepping, "servo_gain", "knee"));
  EXPECT_FALSE(looksFor(stepping, "servo_gain", "hip")) << "it is where it should be";
  EXPECT_TRUE(looksFor(stepping, "link_mass", "upper"));
  EXPECT_TRUE(looksFor(stepping, "joint_offset", "hip")) << "shows in other joints";
}

}  // namespace
}  // namespace plumbline::gap
