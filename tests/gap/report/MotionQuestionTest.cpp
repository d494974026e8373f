#include "gap/report/MotionQuestion.h"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "framework/ConfigurationError.h"
#include "gap/TwoJointArm.h"

namespace plumbline::gap {
namespace {

using nlohmann::json;

class MotionQuestionTest : public ::testing::Test {
protected:
  std::string errorOf(const AnswerCauses& found, const json& answer) const {
    try {
      motionQuestionOf(found, answer, arm, "answer.json");
    } catch (const ConfigurationError& error) {
      return error.what();
    }
    return "";
  }

  const Mechanism arm = twoJointArm();
  const Cause friction = causeOfArm("coulomb_friction", "elbow", 0.1);
  const Cause backlash = causeOfArm("backlash", "shoulder", 0.03);
};

TEST_F(MotionQuestionTest, aRivalIsToBeSeparatedFromTheCauseItWouldReplace) {
  AnswerCauses found;
  found.causes = {backlash, friction};
  found.probabilities = {0.99, 0.7};
  found.rivals = {{1, causeOfArm("viscous_friction", "elbow", 0.2), 0.3}};
  const MotionQuestion question = motionQuestionOf(found, {{"verdict", "effect"}}, arm, "answer.json");
  EXPECT_EQ(question.text,
            "coulomb_friction at elbow = 0.1 N m from viscous_friction at elbow = 0.2 N m s/rad");
  ASSERT_EQ(question.explanations.size(), 2u);
  EXPECT_EQ(question.explanations[0], found.causes);
  EXPECT_EQ(question.explanations[1], (Explanation{backlash, found.rivals.front().cause}));
}

TEST_F(MotionQuestionTest, withoutRivalsItIsAboutTheLeastCertainCause) {
  AnswerCauses found;
  found.causes = {backlash, friction};
  found.probabilities = {0.99, 0.7};
  const MotionQuestion question = motionQuestionOf(found, {{"verdict", "effect"}}, arm, "answer.json");
  EXPECT_EQ(question.text, "coulomb_friction at elbow = 0.1 N m from everything else at its place");
  ASSERT_GE(question.explanations.size(), 3u);
  EXPECT_EQ(question.explanations[0], found.causes);
  for (std::size_t i = 1; i < question.explanations.size(); ++i) {
    EXPECT_EQ(question.explanations[i].front(), backlash);
    EXPECT_NE(question.explanations[i].back().effect, friction.effect);
    EXPECT_EQ(question.explanations[i].back().place.index, friction.place.index);
  }
}

TEST_F(MotionQuestionTest, anUnknownCauseIsSoughtAtTheJointThatShowsIt) {
  const json answer = {{"verdict", "unknown"}, {"worst", {{"signal_after", "pos.elbow"}}}};
  const MotionQuestion question = motionQuestionOf({}, answer, arm, "answer.json");
  EXPECT_EQ(question.text, "what could be behind the gap at elbow");
  EXPECT_EQ(question.joints, std::vector<int>{1});
  EXPECT_FALSE(question.fromFirst);
  EXPECT_GE(question.explanations.size(), 2u);
}

TEST_F(MotionQuestionTest, whereNoMotionHelpsItSaysWhatWould) {
  EXPECT_EQ(errorOf({}, {{"verdict", "none"}}),
            "answer.json: the verdict is none, so there is nothing to separate; faster moves and higher "
            "loads would show smaller effects");
  EXPECT_EQ(errorOf({}, {{"verdict", "unknown"}, {"worst", {{"signal", "gyro.x"}}}}),
            "answer.json: the verdict is unknown and no joint shows it; record the standard battery");
}

TEST_F(MotionQuestionTest, aDiagnosisWithoutALikelyRivalNeedsNoOtherMotion) {
  Diagnosis diagnosis;
  EXPECT_EQ(separatingMotion(arm, diagnosis), "");
  diagnosis.findings.push_back({friction, 0.05, 0.2, 0.97, 1, 1, {{backlash, 0.03}}});
  EXPECT_EQ(separatingMotion(arm, diagnosis), "");
  diagnosis.findings.front().rivals.push_back({causeOfArm("viscous_friction", "elbow", 0.2), 0.3});
  const std::string text = separatingMotion(arm, diagnosis);
  EXPECT_TRUE(text.starts_with("Record ")) << text;
  EXPECT_NE(text.find("coulomb_friction at elbow and viscous_friction at elbow"), std::string::npos) << text;
  Mechanism torques = arm;
  torques.joints[1].servo.kp = 0;
  EXPECT_EQ(separatingMotion(torques, diagnosis), "") << "motions are commanded positions";
}

}  // namespace
}  // namespace plumbline::gap
