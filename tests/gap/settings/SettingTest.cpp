#include "gap/settings/Setting.h"

#include <gtest/gtest.h>

#include "framework/ConfigurationError.h"
#include "gap/settings/SettingsAnswer.h"

namespace plumbline::gap {
namespace {

TEST(Setting, TheSimulatorAsItIsHasTheLeaguesValues) {
  const SimulatorSetup setup;
  for (const Setting& setting : settings()) EXPECT_EQ(setting.get(setup), setting.league) << setting.id;
}

TEST(Setting, WhatIsPutIsThere) {
  for (const Setting& setting : settings()) {
    const double value =
        setting.kind == Setting::Kind::positive ? (setting.lower + setting.upper) / 2 : 1 - setting.league;
    EXPECT_EQ(setting.get(with({}, {{&setting, value}})), value) << setting.id;
    EXPECT_EQ(setting.get(with({}, {{&setting, setting.absent}})), setting.absent) << setting.id;
  }
}

TEST(Setting, LeavingOutChangesThatAlone) {
  for (const std::string& omission : omissions()) {
    const SimulatorSetup setup = without({}, omission);
    const auto ids = settingsOf(omission);
    for (const Setting& setting : settings()) {
      const bool omitted = std::ranges::find(ids, setting.id) != ids.end();
      EXPECT_EQ(setting.get(setup), omitted ? setting.absent : setting.league)
          << omission << ' ' << setting.id;
    }
  }
}

TEST(Setting, UnknownOnesAreNamedWithThoseThereAre) {
  const auto textOf = [](const auto& call) -> std::string {
    try {
      call();
    } catch (const ConfigurationError& error) {
      return error.what();
    }
    return "nothing thrown";
  };
  EXPECT_EQ(textOf([] { without({}, "gravity"); }),
            "--without gravity: unknown; choose one of drag, contact_slip, "
            "contact_softness, joint_softness, motor_torque, action_delay, bouncing_stops");
  EXPECT_EQ(textOf([] { findSetting("drga"); }), "no setting drga; did you mean \"drag\"?");
}

TEST(Setting, ValuesReadAsPeopleWriteThem) {
  EXPECT_EQ(describe({&findSetting("drag"), 0.0101}), "drag = 0.0101 N s/m");
  EXPECT_EQ(describe({&findSetting("contact_erp"), 0.4}), "contact_erp = 0.4");
  EXPECT_EQ(describe({&findSetting("bouncing_stops"), 0}), "bouncing_stops off");
  EXPECT_EQ(valueText(findSetting("motor_torque"), 1e4), "no limit");
  EXPECT_EQ(valueText(findSetting("motor_torque"), 10), "10 N m");
}

}  // namespace
}  // namespace plumbline::gap
