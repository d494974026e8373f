#include "gap/diagnosis/Pairs.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <string_view>

#include "../Pendulum.h"
#include "gap/diagnosis/CauseSearch.h"

namespace plumbline::gap {
namespace {

/// The best pair of a pendulum that has these two.
Explanation pairOf(const Explanation& hidden) {
  const Mechanism robot = pendulum();
  const Evidence evidence(pendulumRecordedTwice(plantOf(robot, hidden), 0));
  const Evaluator fine(robot, evidence), coarse(robot, evidence, coarseSteps());
  return bestPair(fine, coarse, 1);
}

const Cause* find(const Explanation& causes, std::string_view id) {
  const auto at = std::ranges::find_if(causes, [&](const Cause& cause) { return cause.effect->id == id; });
  return at == causes.end() ? nullptr : &*at;
}

TEST(PairsTest, twoOfWhichNeitherFitsBestAlone) {
  const Explanation pair = pairOf(
      {causeOfPendulum("link_mass", "arm", 0.037), causeOfPendulum("coulomb_friction", "pendulum", 0.0157)});
  ASSERT_EQ(pair.size(), 2u);
  const Cause *mass = find(pair, "link_mass"), *friction = find(pair, "coulomb_friction");
  ASSERT_TRUE(mass && friction) << describe(pair[0]) << ", " << describe(pair[1]);
  EXPECT_NEAR(mass->value, 0.037, 0.002);
  EXPECT_NEAR(friction->value, 0.0157, 0.001);
}

TEST(PairsTest, aGainAndALinkThatPullBothWays) {
  const Explanation pair =
      pairOf({causeOfPendulum("servo_gain", "pendulum", 1.08), causeOfPendulum("link_length", "arm", 0.943)});
  ASSERT_EQ(pair.size(), 2u);
  const Cause* length = find(pair, "link_length");
  ASSERT_TRUE(length) << describe(pair[0]) << ", " << describe(pair[1]);
  EXPECT_NEAR(length->value, 0.943, 0.005);
  // A gain and a supply are the same where the duty stays below its limit.
  const Cause *gain = find(pair, "servo_gain"), *supply = find(pair, "supply_voltage");
  ASSERT_TRUE(gain || supply) << describe(pair[0]) << ", " << describe(pair[1]);
  EXPECT_NEAR((gain ? gain : supply)->value, 1.08, 0.005);
}

TEST(PairsTest, oneChainIsWhatAllCausesMove) {
  const Mechanism robot = findMechanism("nao_v5");
  EXPECT_TRUE(hasOneMotor(pendulum()));
  EXPECT_FALSE(hasOneMotor(twoJointArm()));
  const std::vector<Trial> trials = {recorded(nominalPlant(robot), armTrial(robot, 1), 5e-4, 1)};
  const Evidence evidence(trials);
  const Evaluator evaluator(robot, evidence);
  const auto cause = [&](const char* id, const char* at) { return causeOf(robot, id, at, 0.1); };
  const Cause knee = cause("coulomb_friction", "LKneePitch"), ankle = cause("bias_force", "LAnkleRoll"),
              head = cause("bias_force", "HeadYaw"), all = cause("command_delay", "*");
  EXPECT_TRUE(onOneChain(evaluator, {knee, ankle}));
  EXPECT_FALSE(onOneChain(evaluator, {knee, head}));
  EXPECT_FALSE(onOneChain(evaluator, {knee, all}));
  EXPECT_FALSE(onOneChain(evaluator, {}));
}

}  // namespace
}  // namespace plumbline::gap
