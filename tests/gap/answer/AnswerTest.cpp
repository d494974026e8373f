#include "gap/answer/Answer.h"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "../TwoJointArm.h"

namespace plumbline::gap {
namespace {

TEST(AnswerTest, theRecordingsThatRanWithoutACauseAreNamed) {
  const Mechanism arm = twoJointArm();
  Trial trial = armTrial(arm, 1.5);
  trial.recording = "runs/tuesday";
  const Evidence evidence({recorded(nominalPlant(arm), trial, 5e-4, 3)});
  Evaluator evaluator(arm, evidence);
  Diagnosis diagnosis;
  diagnosis.verdict = Verdict::effect;
  for (const char* id : {"acceleration_limit", "coulomb_friction"}) {
    diagnosis.findings.emplace_back();
    diagnosis.findings.back().cause = causeOfArm(id, "elbow", id[0] == 'a' ? 20 : 0.1);
  }
  diagnosis.findings[0].cause.inactiveIn = {"runs/tuesday"};
  const auto answer = nlohmann::json::parse(answerJson({"two_joint_arm", {{}}, ""}, diagnosis, evaluator));
  const auto& effects = answer["effects"];
  EXPECT_EQ(effects[0]["not_in"], nlohmann::json({"runs/tuesday"}));
  EXPECT_EQ(effects[0]["sentence"],
            "The servo of elbow smooths its commands: it keeps an acceleration limit. It was not set "
            "in tuesday.");
  EXPECT_EQ(effects[0]["expected_elsewhere"], false) << "the one recording that there is lacked it";
  EXPECT_FALSE(effects[1].contains("not_in"));
  EXPECT_FALSE(effects[1].contains("expected_elsewhere"));
}

TEST(AnswerTest, theNextMotionNamesAJointOrNone) {
  const Mechanism arm = twoJointArm();
  const Evidence evidence({recorded(nominalPlant(arm), armTrial(arm, 1.5), 5e-4, 3)});
  const auto asked = [&](const std::string& worstSignal) {
    Diagnosis diagnosis;
    diagnosis.verdict = Verdict::unknown;
    diagnosis.worstSignal = worstSignal;
    const std::string text = suggestion(diagnosis, evidence);
    return text.substr(0, text.find(':'));
  };
  EXPECT_EQ(asked("pos.elbow"), "Move only elbow");
  EXPECT_EQ(asked("gyro.x"), "Move one joint at a time") << "which no joint is";
  EXPECT_EQ(asked(""), "Move one joint at a time") << "no channel is worst";
}

TEST(AnswerTest, aDrawnSignalHasFifteenHundredPointsAtMost) {
  const Mechanism arm = twoJointArm();
  for (const double seconds : {14.0, 17.0}) {
    const Evidence evidence({recorded(nominalPlant(arm), armTrial(arm, seconds), 5e-4, 3)});
    Evaluator evaluator(arm, evidence);
    const auto answer = nlohmann::json::parse(answerJson({"two_joint_arm", {{}}, ""}, {}, evaluator));
    ASSERT_EQ(answer["overlays"].size(), 2U);
    for (const auto& overlay : answer["overlays"])
      for (const char* key : {"t", "measured", "nominal", "corrected"})
        EXPECT_EQ(overlay[key].size(), seconds < 15 ? 1400U : 850U) << key;
  }
}

}  // namespace
}  // namespace plumbline::gap
