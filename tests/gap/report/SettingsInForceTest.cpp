#include "gap/report/SettingsInForce.h"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "../SomeRecordings.h"
#include "gap/inference/HoldOut.h"

namespace plumbline::gap {

using nlohmann::json;

/// An answer with an acceleration limit that one recording lacked, and friction.
json answerWithALimit(bool expected) {
  json limit{{"effect", "acceleration_limit"},
             {"at", "elbow"},
             {"axis", nullptr},
             {"value", 20},
             {"variant", nullptr}};
  json friction = limit;
  limit["not_in"] = {"some/where"};
  limit["expected_elsewhere"] = expected;
  friction["effect"] = "coulomb_friction";
  friction["value"] = 0.08;
  return {{"effects", {limit, friction}}};
}

const Explanation& truth() {
  static const Explanation causes{causeOfArm("acceleration_limit", "elbow", 20),
                                  causeOfArm("coulomb_friction", "elbow", 0.08)};
  return causes;
}

TEST(SettingsInForce, eachSettingThatSomeLackedIsTakenOutOrPutIn) {
  const Mechanism arm = twoJointArm();
  const auto expected = settingChoices(answerWithALimit(true), "a.json", arm, truth());
  ASSERT_EQ(expected.size(), 1U);
  EXPECT_EQ(expected[0].effect, "acceleration_limit");
  EXPECT_TRUE(expected[0].expected);
  EXPECT_EQ(expected[0].with, truth());
  EXPECT_EQ(expected[0].without, Explanation{truth()[1]});
  const auto unexpected = settingChoices(answerWithALimit(false), "a.json", arm, {truth()[1]});
  ASSERT_EQ(unexpected.size(), 1U);
  EXPECT_FALSE(unexpected[0].expected);
  EXPECT_EQ(unexpected[0].with, (Explanation{truth()[1], truth()[0]}));
}

TEST(SettingsInForce, aRecordingSaysWhetherItHadTheSetting) {
  const Mechanism arm = twoJointArm();
  const std::vector<Trial> trials = someRecordings(truth(), "tuesday");
  const auto choices = settingChoices(answerWithALimit(true), "a.json", arm, truth());
  for (const Trial& trial : trials) {
    const Prediction nominal = replay(plantOf(trial, {}), trial);
    const double left = leftIn(trial, nominal, {{0, truth()}}).after;
    const SettingSeen seen = settingsSeen(trial, nominal, left, choices).at(0);
    EXPECT_EQ(seen.isUnexpected(), trial.recording == "tuesday");
    EXPECT_EQ(seen.isNearerWith(), trial.recording != "tuesday");
  }
}

TEST(SettingsInForce, inWords) {
  EXPECT_EQ(
      (SettingSeen{"multisine", "acceleration_limit", true, 0.0155, 0.0035}.sentence()),
      "multisine: with acceleration_limit 15.5 mrad are left, without it 3.5: it may have been recorded "
      "without that setting.");
  EXPECT_EQ((SettingSeen{"sweep", "dead_band", false, 0.002, 0.02}.sentence()),
            "sweep: without dead_band 20.0 mrad are left, with it 2.0: it may have been recorded with that "
            "setting.");
}

}  // namespace plumbline::gap
