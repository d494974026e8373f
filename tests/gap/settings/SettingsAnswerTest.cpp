#include "gap/settings/SettingsAnswer.h"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

namespace plumbline::gap {
namespace {

TEST(SettingsAnswer, placesWithHalfAPerCentOfTheGapAreListed) {
  SettingsDiagnosis diagnosis;
  for (const double share : {0.9, 0.006, 0.004}) {
    diagnosis.cells.push_back({"gyro", "walk", "rad/s", 0.2, 0.1, 0.1, share});
  }
  const nlohmann::json where = nlohmann::json::parse(settingsJson(diagnosis, "type0"))["where"];
  ASSERT_EQ(where.size(), 2U);
  EXPECT_DOUBLE_EQ(where[0]["share"], 0.9);
  EXPECT_DOUBLE_EQ(where[1]["share"], 0.006);
  EXPECT_EQ(where[0]["signal"], "gyro");
  EXPECT_EQ(where[0]["unit"], "rad/s");
}

TEST(SettingsAnswer, whereNothingIsMissingTheSentenceSaysSo) {
  EXPECT_EQ(settingsSentence({}),
            "The simulator as it is explains these recordings as well as it would explain its own.");
}

}  // namespace
}  // namespace plumbline::gap
