#include "gap/inference/CommandLosses.h"

#include <gtest/gtest.h>

#include "../TwoJointArm.h"
#include "gap/diagnosis/LostCycles.h"

namespace plumbline::gap {
namespace {

class CommandLossesTest : public ::testing::Test {
protected:
  static std::vector<Trial> repeats(double share) {
    return recordedTwice(nominalPlant(twoJointArm()), 5e-4, share);
  }
};

TEST_F(CommandLossesTest, theShareIsOfTheTrialsAskedForAndOfCyclesThatShowALoss) {
  CommandLosses lost;
  EXPECT_FALSE(lost.any());
  lost.seen = {100, 300};
  lost.found = {20, 30};
  EXPECT_DOUBLE_EQ(lost.share(), 0.125);
  EXPECT_DOUBLE_EQ(lost.share({0, 1}), 0.1);
  EXPECT_TRUE(lost.any());
}

TEST_F(CommandLossesTest, theIntervalIsWilsons) {
  CommandLosses lost;
  lost.seen = {100};
  lost.found = {10};
  EXPECT_NEAR(lost.interval().lower, 0.0552, 1e-4);
  EXPECT_NEAR(lost.interval().upper, 0.1744, 1e-4);
}

TEST_F(CommandLossesTest, whatDecodingMissesIsMadeUpFor) {
  CommandLosses lost;
  lost.seen = {100, 100};
  lost.found = {10, 5};
  EXPECT_DOUBLE_EQ(lost.share(), 0.075);
  lost.recovered = 0.75;
  lost.foundInSimulation = 15;
  EXPECT_DOUBLE_EQ(lost.share(), 0.1);
  EXPECT_NEAR(lost.share({1, 0}), 0.4 / 3, 1e-12);
  // As of 7.5 in 100, divided by the same.
  EXPECT_NEAR(lost.interval().lower, 0.0502, 1e-4);
  EXPECT_NEAR(lost.interval().upper, 0.1917, 1e-4);
}

TEST_F(CommandLossesTest, ofAServoThatShowsLossesAtOnceNearlyAllAreFound) {
  const std::vector<Trial> sent = repeats(0.1);
  CommandLosses lost = decodeLostCommands(sent, Groups(sent), {}, 1);
  const std::vector<Trial> known = withLost(sent, lost);
  measureRecovery(lost, sent, Groups(known, predictionsOf(known, {}, 1)), {}, 1);
  EXPECT_NEAR(lost.recovered, 1, 0.15);
  EXPECT_GT(lost.foundInSimulation, 50U);
}

TEST_F(CommandLossesTest, asACauseTheyAreOfTheWholeRobot) {
  EXPECT_EQ(describe(CommandLosses::cause(0.07)), "command_dropout at * = 0.07");
  EXPECT_EQ(plantOf(twoJointArm(), {CommandLosses::cause(0.07)}).dropout, 0.07);
}

TEST_F(CommandLossesTest, repeatsThatAgreeLostNone) {
  EXPECT_FALSE(mayHaveLostCommands(Groups(repeats(0))));
  EXPECT_TRUE(mayHaveLostCommands(Groups(repeats(0.1))));
  std::vector<Trial> once = repeats(0);
  once.pop_back();
  EXPECT_TRUE(mayHaveLostCommands(Groups(once)));  // nothing was repeated
  once[0].freeBase = true;
  EXPECT_FALSE(mayHaveLostCommands(Groups(once)));  // which commands were lost is not decoded on the feet
}

TEST_F(CommandLossesTest, whatWasLostIsDecodedAndWorthItsPrice) {
  const std::vector<Trial> sent = repeats(0.1);
  const Mechanism arm = twoJointArm();
  CommandLosses lost = decodeLostCommands(sent, Groups(sent), {}, 1);
  EXPECT_NEAR(lost.share(), 0.1, 0.02);
  const std::vector<Trial> known = withLost(sent, lost);
  const Groups groups(known, predictionsOf(known, {}, 1));
  const double evidence = evidenceOf(lost, Replayer(arm, groups, 1), {}, {}, 40);
  EXPECT_GT(evidence, 100);
  // The price of a cause among 1600 kinds instead of 40.
  EXPECT_NEAR(evidence - evidenceOf(lost, Replayer(arm, groups, 1), {}, {}, 1600), std::log(40.0), 1e-9);
  // Cycles that explain nothing cost.
  CommandLosses more = lost;
  for (std::size_t t = 0; t < 2; ++t) more.found[t] *= 2;
  EXPECT_LT(evidenceOf(more, Replayer(arm, groups, 1), {}, {}, 40), evidence - 100);
}

TEST_F(CommandLossesTest, whereManyAreLostLessEvidenceIsEnoughForEach) {
  Mechanism weak = twoJointArm();
  for (Mechanism::Joint& joint : weak.joints) {
    joint.servo.kp = 4;
    joint.servo.kd = 0.15;
  }
  const std::vector<Trial> sent = recordedTwice(nominalPlant(weak), 3e-4, 0.3, armTrial(weak, 3));
  const Groups groups(sent);
  std::vector<std::vector<SignalNoise>> noises;
  for (const auto& uses : groups.uses()) {
    auto& of = noises.emplace_back();
    for (const ChannelUse& use : uses) of.push_back({use.readingNoise, use.readingNoise, false});
  }
  const LostCycles sure = findLostCycles(Evidence(sent, std::move(noises)), {}, 1);
  const CommandLosses lost = decodeLostCommands(sent, groups, {}, 1);
  EXPECT_TRUE(sure.slow);
  EXPECT_GT(lost.share(), sure.share + 0.015);
  EXPECT_LT(lost.share(), 0.31);
}

TEST_F(CommandLossesTest, ofRecordingsThatLostNothingNothingIsDecoded) {
  const std::vector<Trial> sent = repeats(0);
  const CommandLosses lost = decodeLostCommands(sent, Groups(sent), {}, 1);
  EXPECT_FALSE(lost.any());
  EXPECT_EQ(lost.cycles.size(), 2U);
}

}  // namespace
}  // namespace plumbline::gap
