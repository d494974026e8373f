#pragma once
#include <string>

#include "gap/settings/SettingsDiagnosis.h"

namespace plumbline::gap {

/// The answer as JSON text in the form of doc/reference/gap-answer.md: `effect` is the id of a setting, `at`
/// "simulator". doc/reference/gap-settings.md describes it.
std::string settingsJson(const SettingsDiagnosis& diagnosis, const std::string& robot);

/// The verdict in a sentence or two, for people.
std::string settingsSentence(const SettingsDiagnosis& diagnosis);

/// "off", "0.01 N s/m", "no limit"
std::string valueText(const Setting& setting, double value);

}  // namespace plumbline::gap
