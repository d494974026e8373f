#include "gap/settings/SettingsDiagnosis.h"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "gap/LeagueTraces.h"
#include "gap/settings/SettingsAnswer.h"

namespace plumbline::gap {
namespace {

TEST(SettingsDiagnosis, FindsTheDelayThatWasLeftOut) {
  const SettingsDiagnosis diagnosis = diagnosisOfTraces(without({}, "action_delay"));
  EXPECT_EQ(diagnosis.verdict, Verdict::effect);
  ASSERT_EQ(diagnosis.findings.size(), 1u);
  EXPECT_EQ(diagnosis.findings[0].value.setting->id, "action_delay");
  EXPECT_EQ(diagnosis.findings[0].value.value, 1);
  EXPECT_EQ(diagnosis.findings[0].nominal, 0);
  EXPECT_GT(diagnosis.gap.closed(), 0.9);
  const auto answer = nlohmann::json::parse(settingsJson(diagnosis, "simspark"));
  EXPECT_EQ(answer["verdict"], "effect");
  EXPECT_EQ(answer["effects"][0]["effect"], "action_delay");
  EXPECT_EQ(answer["effects"][0]["at"], "simulator");
  EXPECT_TRUE(answer["gap"]["held_out"]);
  EXPECT_FALSE(answer["next_motion"].get<std::string>().empty());
}

TEST(SettingsDiagnosis, FindsTheDragThatWasLeftOutWithItsValue) {
  const SettingsDiagnosis diagnosis = diagnosisOfTraces(without({}, "drag"));
  ASSERT_EQ(diagnosis.findings.size(), 1u);
  EXPECT_EQ(diagnosis.findings[0].value.setting->id, "drag");
  EXPECT_NEAR(diagnosis.findings[0].value.value, 0.01, 0.0015);
}

TEST(SettingsDiagnosis, WhatNoSettingExplainsIsUnknown) {
  SimulatorSetup nominal;
  nominal.stepsPerRow = 2;
  nominal.world.stepSeconds = 0.01;
  EXPECT_EQ(diagnosisOfTraces(nominal).verdict, Verdict::unknown);
}

}  // namespace
}  // namespace plumbline::gap
