#include "gap/report/AnswerCauses.h"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "framework/ConfigurationError.h"
#include "support/Thrown.h"

namespace plumbline::gap {

using nlohmann::json;

json effectAt(const char* id, const char* at, double value) {
  return {{"effect", id}, {"at", at}, {"axis", nullptr}, {"value", value}, {"variant", nullptr}};
}

TEST(AnswerCauses, aSettingThatMostRecordingsLackedIsNotReplayedInOthers) {
  json answer{
      {"effects", {effectAt("acceleration_limit", "elbow", 20), effectAt("backlash", "elbow", 0.02)}}};
  answer["effects"][0]["expected_elsewhere"] = false;
  const auto replayed = replayedSettingsOf(answer, "a.json");
  ASSERT_EQ(replayed.size(), 1U);
  EXPECT_EQ(replayed[0].effect, "backlash");
  EXPECT_EQ(settingsOf(answer, "a.json").size(), 2U) << "it was found all the same";
  answer["effects"][0]["expected_elsewhere"] = true;
  EXPECT_EQ(replayedSettingsOf(answer, "a.json").size(), 2U);
}

TEST(AnswerCauses, aModelWithValuesInEachJointIsReplayedInsteadOfTheEffects) {
  json answer{{"effects", {effectAt("backlash", "*", 0.02)}}};
  answer["gap"]["model"] = {effectAt("backlash", "elbow", 0.01), effectAt("backlash", "shoulder", 0.03)};
  const auto replayed = replayedSettingsOf(answer, "a.json");
  ASSERT_EQ(replayed.size(), 2U);
  EXPECT_EQ(replayed[1].at, "shoulder");
  EXPECT_EQ(replayed[1].value, 0.03);
  answer["gap"]["model"][1].erase("value");
  EXPECT_EQ(thrownBy([&] { replayedSettingsOf(answer, "a.json"); }),
            "a.json: gap.model[1]: lacks 'effect', 'at' or a number 'value'");
}

}  // namespace plumbline::gap
