#include "gap/settings/SettingsDiagnosis.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <nlohmann/json.hpp>

#include "framework/ConfigurationError.h"
#include "gap/settings/SettingsAnswer.h"

namespace plumbline::gap {
namespace {

/// Some recordings of the league's server, their first seconds.
std::vector<simspark::LeagueTrace> someTraces() {
  std::vector<simspark::LeagueTrace> traces;
  for (const char* name :
       {"crouch_t0", "crouch_t1", "ut_turn_t1", "ut_turn_t2", "ut_walk_t0", "ut_walk_t3"}) {
    traces.push_back(simspark::readLeagueTrace(std::string("tests/data/traces/") + name + ".csv.gz"));
    traces.back().rows.resize(180);
  }
  return traces;
}

SettingsDiagnosis diagnosisOf(const SimulatorSetup& nominal) {
  const TraceEvidence evidence(someTraces(), 5, 16);
  SettingsOptions options;
  options.jobs = 2;
  return diagnoseSettings(evidence, nominal, options);
}

std::string errorOf(const std::function<void()>& call) {
  try {
    call();
  } catch (const std::exception& error) {
    return error.what();
  }
  return "nothing thrown";
}

TEST(TracePlay, RepeatsTheServerWithinATenthOfAMillimetre) {
  const auto trace = simspark::readLeagueTrace("tests/data/traces/ut_walk_t0.csv.gz");
  const auto rows = play(trace, 100, 5, {});
  ASSERT_EQ(rows.size(), 5u);
  EXPECT_LT((rows[4].torso.translation() - trace.rows[105].torso.translation()).norm(), 3e-4);
  EXPECT_NEAR(rows[4].angle[lKneePitch], trace.rows[105].angle[lKneePitch], 2e-3);
  // Played a cycle too early, the knee is elsewhere.
  SimulatorSetup early;
  early.delay = 0;
  EXPECT_GT(std::abs(play(trace, 100, 5, early)[2].angle[lKneePitch] - trace.rows[103].angle[lKneePitch]),
            0.01);
}

TEST(TracePlay, SaysWhereItCannotBegin) {
  const auto trace = simspark::readLeagueTrace("tests/data/traces/crouch_t0.csv.gz");
  EXPECT_EQ(errorOf([&] { play(trace, 2, 5, {}); }), "crouch_t0: no replay from row 2");
}

TEST(TraceEvidence, HoldsOutWholeRobotTypesAndLeavesIdleWindowsOut) {
  const TraceEvidence evidence(someTraces(), 5, 16);
  for (const TraceWindow& window : evidence.windows()) {
    const int type = *evidence.traces()[window.trace].robotType;
    EXPECT_EQ(window.heldOut, type == 1 || type == 3);
    // The crouch begins with a small drop and then rests until row 50.
    if (evidence.traces()[window.trace].name.starts_with("crouch")) {
      EXPECT_TRUE(window.first < 10 || window.first > 44) << window.first;
    }
  }
}

TEST(TraceEvidence, NeedsRecordingsForBoth) {
  auto one = someTraces();
  one.resize(1);
  EXPECT_EQ(
      errorOf([&] { TraceEvidence evidence(one); }),
      "too few recordings in which the robot moves: some are for fitting and some of another robot type for "
      "judging; give at least two");
  EXPECT_EQ(errorOf([] { readTraces("no/such/folder"); }),
            "no/such/folder: no folder of recordings can be read here");
  const auto empty = std::filesystem::temp_directory_path() / "plumbline-no-traces";
  std::filesystem::create_directories(empty);
  EXPECT_EQ(errorOf([&] { readTraces(empty); }),
            empty.string() + ": no recordings of a robot, *_t0.csv.gz to *_t4.csv.gz, are in this folder");
}

TEST(SettingsDiagnosis, NothingIsMissingWhereNothingIs) {
  const SettingsDiagnosis diagnosis = diagnosisOf({});
  EXPECT_EQ(diagnosis.verdict, Verdict::none);
  EXPECT_TRUE(diagnosis.findings.empty());
}

TEST(SettingsDiagnosis, FindsTheDelayThatWasLeftOut) {
  const SettingsDiagnosis diagnosis = diagnosisOf(without({}, "action_delay"));
  EXPECT_EQ(diagnosis.verdict, Verdict::effect);
  ASSERT_EQ(diagnosis.findings.size(), 1u);
  EXPECT_EQ(diagnosis.findings[0].value.setting->id, "action_delay");
  EXPECT_EQ(diagnosis.findings[0].value.value, 1);
  EXPECT_EQ(diagnosis.findings[0].nominal, 0);
  EXPECT_GT(diagnosis.gap.closed(), 0.9);
  const auto answer = nlohmann::json::parse(settingsJson(diagnosis, "simspark", 1));
  EXPECT_EQ(answer["verdict"], "effect");
  EXPECT_EQ(answer["effects"][0]["effect"], "action_delay");
  EXPECT_EQ(answer["effects"][0]["at"], "simulator");
  EXPECT_TRUE(answer["gap"]["held_out"]);
  EXPECT_FALSE(answer["next_motion"].get<std::string>().empty());
}

TEST(SettingsDiagnosis, FindsTheDragThatWasLeftOutWithItsValue) {
  const SettingsDiagnosis diagnosis = diagnosisOf(without({}, "drag"));
  ASSERT_EQ(diagnosis.findings.size(), 1u);
  EXPECT_EQ(diagnosis.findings[0].value.setting->id, "drag");
  EXPECT_NEAR(diagnosis.findings[0].value.value, 0.01, 0.0015);
}

TEST(SettingsDiagnosis, WhatNoSettingExplainsIsUnknown) {
  SimulatorSetup nominal;
  nominal.stepsPerRow = 2;
  nominal.world.stepSeconds = 0.01;
  EXPECT_EQ(diagnosisOf(nominal).verdict, Verdict::unknown);
}

}  // namespace
}  // namespace plumbline::gap
