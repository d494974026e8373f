#include "gap/report/AnswerFile.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>

#include "framework/ConfigurationError.h"
#include "gap/TwoJointArm.h"
#include "gap/report/AnswerCauses.h"
#include "gap/report/ReportPage.h"

namespace plumbline::gap {
namespace {

using nlohmann::json;

std::string written(const std::string& text) {
  const std::string path = (std::filesystem::path(testing::TempDir()) / "answer.json").string();
  std::ofstream(path) << text;
  return path;
}

std::string refusal(const std::string& text) {
  const std::string path = written(text);
  try {
    readAnswer(path);
  } catch (const ConfigurationError& error) {
    const std::string what = error.what();
    const std::string tail = "; bin/gap diagnose RUNS --json FILE writes an answer";
    EXPECT_TRUE(what.starts_with(path + ":")) << what;
    EXPECT_TRUE(what.ends_with(tail)) << what;
    const std::size_t from = path.size() + (what[path.size() + 1] == ' ' ? 2 : 1);  // else there is a line
    return what.substr(from, what.size() - from - tail.size());
  }
  return "";
}

TEST(AnswerFile, RefusesWhatIsNoAnswerInOneLine) {
  EXPECT_EQ(refusal("{"), "1: broken JSON");
  EXPECT_EQ(
      refusal("{\"verdict\": \"none\", \"x\": " + std::string(100000, '[') + std::string(100000, ']') + "}"),
      "is nested deeper than 16 levels");
  EXPECT_EQ(refusal(R"({"a": 1, "a": 2})"), "key \"a\" occurs twice in one object");
  EXPECT_EQ(refusal("[]"), "is no JSON map");
  EXPECT_EQ(refusal("{}"), "has no 'verdict'");
  EXPECT_EQ(refusal(R"({"verdict": "maybe"})"),
            "has the verdict 'maybe'; it must be none, effect or unknown");
  EXPECT_EQ(refusal(R"({"verdict": "none"})"), "has no list 'effects'");
  EXPECT_EQ(refusal(R"({"verdict": "effect", "effects": [3]})"), "effects[0] is no map");
  EXPECT_EQ(refusal(R"({"verdict": "effect", "effects": [{"effect": "backlash"}]})"),
            "effects[0] lacks 'effect' or 'at'");
  EXPECT_EQ(refusal(R"({"verdict": "effect", "effects": [{"effect": "backlash", "at": "A", "value": "x"}]})"),
            "effects[0] has no number as 'value'");
  EXPECT_EQ(refusal(R"({"verdict": "none", "effects": []})"), "");
}

TEST(AnswerFile, RefusesWhatIsNoCheckInOneLine) {
  const auto refused = [](const std::string& text) -> std::string {
    const std::string path = written(text);
    try {
      readCheck(path);
    } catch (const ConfigurationError& error) {
      return std::string(error.what()).substr(path.size());
    }
    return "";
  };
  const std::string tail = "; bin/gap check ANSWER RUNS --json FILE writes one";
  EXPECT_EQ(refused("[]"), ": is no JSON map" + tail);
  EXPECT_EQ(refused(R"({"closed": "much", "runs": []})"),
            ": has no number 'closed' or no list 'runs'" + tail);
  EXPECT_EQ(refused(R"({"closed": 0.5, "runs": [{"folder": "a", "before": 1}]})"),
            ": runs[0] lacks 'folder', 'before' or 'after'" + tail);
  EXPECT_EQ(refused(R"({"closed": 0.5, "runs": [{"folder": "a", "before": 1, "after": 0.5}]})"), "");
}

TEST(AnswerFile, CausesForARobotWithTheirRivals) {
  const Mechanism robot = twoJointArm();
  const std::string joint = robot.joints[1].name;
  json answer = {
      {"verdict", "effect"},
      {"effects",
       {{{"effect", "backlash"},
         {"at", joint},
         {"axis", nullptr},
         {"value", 0.03},
         {"interval", {0.02, 0.04}},
         {"probability", 0.7},
         {"confounded_with",
          {{{"effect", "dead_band"}, {"at", joint}, {"value", 0.01}, {"probability", 0.1}},
           {{"effect", "joint_compliance"}, {"at", joint}, {"value", 0.01}, {"probability", 0.2}}}}}}}};
  const AnswerCauses causes = causesOf(answer, "a.json", robot);
  ASSERT_EQ(causes.causes.size(), 1U);
  EXPECT_EQ(causes.causes[0].effect->id, "backlash");
  EXPECT_EQ(causes.intervals[0], std::pair(0.02, 0.04));
  ASSERT_EQ(causes.rivals.size(), 2U);
  EXPECT_EQ(causes.rivals[0].cause.effect->id, "joint_compliance");
  EXPECT_EQ(causes.rivals[1].cause.value, 0.01);

  answer["effects"][0]["effect"] = "backlsh";
  try {
    causesOf(answer, "a.json", robot);
    FAIL() << "an effect that is none";
  } catch (const ConfigurationError& error) {
    EXPECT_STREQ(error.what(),
                 "a.json: effects[0]: effect is \"backlsh\"; the library has no such effect; did you mean "
                 "\"backlash\"?");
  }
}

TEST(AnswerFile, ReadsTheValuesOfAllJoints) {
  json answer = {{"verdict", "unknown"}, {"gap", {{"further", nullptr}}}};
  const auto refused = [&] {
    try {
      furtherSettingsOf(answer, "a.json");
    } catch (const ConfigurationError& error) {
      return std::string(error.what());
    }
    return std::string();
  };
  const std::string none =
      "a.json: has no values of all joints (gap.further.model); answers with the verdict unknown about "
      "robots whose base is fixed have them";
  EXPECT_EQ(refused(), none);
  answer["gap"] = 3;
  EXPECT_EQ(refused(), none);
  const json friction = {{"effect", "load_friction"},
                         {"at", "elbow"},
                         {"value", 0.3},
                         {"variant", "load as what reaches the link"}};
  answer["gap"] = {{"further", {{"model", {friction, {{"effect", "backlash"}, {"at", "elbow"}}}}}}};
  EXPECT_EQ(refused(), "a.json: gap.further.model[1]: lacks 'effect', 'at' or a number 'value'");
  answer["gap"]["further"]["model"].erase(1);
  const std::vector<simulation::EffectSetting> settings = furtherSettingsOf(answer, "a.json");
  ASSERT_EQ(settings.size(), 1U);
  EXPECT_EQ(settings[0].value, 0.3);
  EXPECT_EQ(settings[0].variant, "load as what reaches the link");
}

TEST(AnswerFile, ReplaysTheValuesInEachJointWhereThereAreSome) {
  const json friction = {{"effect", "coulomb_friction"}, {"at", "*"}, {"value", 0.1}};
  json answer = {{"verdict", "unknown"}, {"effects", {friction}}, {"gap", json::object()}};
  EXPECT_EQ(replayedSettingsOf(answer, "a.json").at(0).at, "*");
  answer["gap"]["model"] = {{{"effect", "coulomb_friction"}, {"at", "shoulder"}, {"value", 0.15}},
                            {{"effect", "coulomb_friction"}, {"at", "elbow"}, {"value", 0.05}}};
  const std::vector<simulation::EffectSetting> settings = replayedSettingsOf(answer, "a.json");
  ASSERT_EQ(settings.size(), 2U);
  EXPECT_EQ(settings[1].at, "elbow");
  EXPECT_EQ(settings[1].value, 0.05);
  answer["gap"]["model"][1].erase("value");
  try {
    replayedSettingsOf(answer, "a.json");
    FAIL() << "a cause without a value";
  } catch (const ConfigurationError& error) {
    EXPECT_STREQ(error.what(), "a.json: gap.model[1]: lacks 'effect', 'at' or a number 'value'");
  }
}

TEST(ReportPage, HoldsTheAnswerAndNothingThatEndsItsScript) {
  const json answer = {{"verdict", "none"}, {"effects", json::array()}, {"robot", "</script><b>"}};
  const std::string page = reportPage("<script>/*ANSWER*/</script>", answer, twoJointArm());
  EXPECT_TRUE(page.starts_with("<script>{")) << page;
  EXPECT_TRUE(page.ends_with("}</script>"));
  EXPECT_EQ(page.find("</script>"), page.size() - 9);
  const json inside = json::parse(page.substr(8, page.size() - 17));
  EXPECT_EQ(inside["robot"], "</script><b>");
  EXPECT_EQ(inside["figure"]["joints"].size(), 2U);
  EXPECT_EQ(inside["figure"]["joints"][1]["parent"], 0);
  EXPECT_TRUE(inside["figure"]["joints"][1]["leaf"]);
  EXPECT_FALSE(inside["figure"]["joints"][0]["leaf"]);
}

}  // namespace
}  // namespace plumbline::gap
