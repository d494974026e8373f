#include "gap/answer/SetsAnswer.h"

#include <gtest/gtest.h>

#include "../TwoJointArm.h"

namespace plumbline::gap {
namespace {

struct SetsAnswerTest : ::testing::Test {
  nlohmann::json answer(const AllJointFit& further = {}) {
    return setsAnswer(inference, further, {"two_joint_arm", {{}}, ""}, evidence, arm);
  }
  const Mechanism arm = twoJointArm();
  const Evidence evidence{{recorded(nominalPlant(arm), armTrial(arm, 1.5), 5e-4, 3)}};
  Inference inference;
};

TEST_F(SetsAnswerTest, saysWhatRecordingsLeftOutSay) {
  inference.claim = {.closed = 0.6, .lower = 0.3, .upper = 0.8};
  inference.leftOut.resize(2);
  inference.replays = 17;
  inference.notUsed = {"vel.* is not used: it is the difference of positions"};
  const nlohmann::json said = answer();
  EXPECT_EQ(said["method"], "sets");
  EXPECT_EQ(said["gap"]["closed"], 0.6);
  EXPECT_EQ(said["gap"]["closed_interval"], nlohmann::json({0.3, 0.8}));
  EXPECT_EQ(said["gap"]["left_out"], "recordings");
  EXPECT_EQ(said["gap"]["runs"].size(), 2U);
  EXPECT_TRUE(said["gap"]["further"].is_null()) << "no fit of all joints was made";
  EXPECT_EQ(said["replays"], 17);
  EXPECT_EQ(said["remarks"].back(), inference.notUsed.front());
  inference.stretchesOfOne = true;
  EXPECT_EQ(answer()["gap"]["left_out"], "stretches of the one recording");
}

TEST_F(SetsAnswerTest, showsTheRecordingWithTheCommandsThatItLost) {
  const std::vector<Trial> trials = recordedTwice(nominalPlant(arm), 5e-4, 0.1);
  std::vector<std::vector<SignalNoise>> noises(2, std::vector<SignalNoise>(2, {5e-4, 5e-4, false}));
  const Evidence losing(trials, noises);
  inference.lost = decodeLostCommands(trials, Groups(trials), {}, 1);
  inference.diagnosis.findings.emplace_back().cause = CommandLosses::cause(inference.lost.share());
  inference.diagnosis.findings[0].evidence = 1000;
  const nlohmann::json said = setsAnswer(inference, {}, {"two_joint_arm", {{}, {}}, ""}, losing, arm);
  ASSERT_EQ(said["per_signal"].size(), 2U);
  for (const nlohmann::json& signal : said["per_signal"]) {
    EXPECT_GT(signal["before"], 3e-3) << signal;
    EXPECT_LT(signal["after"], 1.2e-3) << signal;
  }
}

TEST_F(SetsAnswerTest, aFitOfAllJointsIsAttributedToNothing) {
  AllJointFit further;
  further.parameters = 66;
  further.closed = 0.12;
  further.model = {causeOfArm("coulomb_friction", "elbow", 0.1)};
  const nlohmann::json said = answer(further), all = said["gap"]["further"];
  EXPECT_EQ(all["parameters"], 66);
  EXPECT_EQ(all["attributable"], false);
  EXPECT_EQ(all["model"].size(), 1U);
  const std::string sentence = said["sentence"];
  EXPECT_TRUE(sentence.ends_with(
      " A further 12 % closes by fitting 66 values of all joints at once; not attributable."))
      << sentence;
}

}  // namespace
}  // namespace plumbline::gap
