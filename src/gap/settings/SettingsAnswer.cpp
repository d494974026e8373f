#include "gap/settings/SettingsAnswer.h"

#include <cmath>
#include <cstdio>
#include <nlohmann/json.hpp>

namespace plumbline::gap {

namespace {

using nlohmann::json;

json number(double value) {
  if (!std::isfinite(value)) return nullptr;
  char text[32];
  std::snprintf(text, sizeof text, "%.6g", value);
  return std::strtod(text, nullptr);
}

json valueJson(const SettingValue& value) {
  return {{"effect", value.setting->id},
          {"at", "simulator"},
          {"axis", nullptr},
          {"value", number(value.value)},
          {"unit", value.setting->unit}};
}

}  // namespace

std::string valueText(const Setting& setting, double value) {
  if (setting.kind == Setting::Kind::onOff) return value != 0 ? "on" : "off";
  if (value >= 1e4) return "no limit";
  char text[32];
  std::snprintf(text, sizeof text, "%.3g", value);
  return text + (setting.unit == "1" ? std::string() : " " + std::string(setting.unit));
}

std::string settingsSentence(const SettingsDiagnosis& diagnosis) {
  const double closed = 100 * std::min(1.0, diagnosis.gap.closed());
  char text[160];
  if (diagnosis.verdict == Verdict::none)
    return "The simulator as it is explains these recordings as well as it would explain its own.";
  std::string list;
  for (const SettingFinding& f : diagnosis.findings) {
    std::snprintf(text, sizeof text, " (%.0f %%)", 100 * f.probability);
    list +=
        (list.empty() ? "" : ", ") + std::string(f.value.setting->missing) + ": " + describe(f.value) + text;
  }
  if (diagnosis.verdict == Verdict::effect) {
    std::snprintf(text, sizeof text,
                  "; it closes %.0f %% of the gap on recordings that were not used for the fit.", closed);
    return "The simulator lacks " + list + text;
  }
  std::snprintf(
      text, sizeof text,
      "No setting of this simulator explains the gap: %.3g times its own spread remain where %.3g were.",
      diagnosis.gap.after / diagnosis.gap.floor, diagnosis.gap.before / diagnosis.gap.floor);
  return text + (list.empty() ? std::string() : " What helps, and is not enough: " + list + ".");
}

std::string settingsJson(const SettingsDiagnosis& diagnosis, const std::string& robot) {
  json j;
  j["verdict"] = nameOf(diagnosis.verdict);
  j["sentence"] = settingsSentence(diagnosis);
  j["robot"] = robot;
  j["where"] = json::array();
  for (const SettingCell& cell : diagnosis.cells)
    if (cell.share >= 0.005)
      j["where"].push_back({{"signal", cell.signal},
                            {"phase", cell.motion},
                            {"unit", cell.unit},
                            {"gap_rms", number(cell.gap)},
                            {"noise_rms", number(cell.floor)},
                            {"after_rms", number(cell.after)},
                            {"share", number(cell.share)}});
  j["effects"] = json::array();
  for (const SettingFinding& f : diagnosis.findings) {
    json e = valueJson({f.value.setting, f.value.value});
    e["nominal"] = number(f.nominal);
    e["interval"] = {number(f.lower), number(f.upper)};
    e["probability"] = number(f.probability);
    e["gap_closed"] = e["closed_alone"] = number(f.closedAlone);
    e["closed_last"] = number(f.closedLast);
    e["confounded_with"] = json::array();
    for (const SettingRival& rival : f.rivals) {
      json other = valueJson(rival.value);
      other["probability"] = number(rival.probability);
      e["confounded_with"].push_back(other);
    }
    j["effects"].push_back(e);
  }
  j["gap"] = {{"before", number(diagnosis.gap.before)},
              {"after", number(diagnosis.gap.after)},
              {"floor", number(diagnosis.gap.floor)},
              {"closed", number(std::min(1.0, diagnosis.gap.closed()))},
              {"held_out", true},
              {"unit", "what the nominal simulator's own runs leave"}};
  j["known_probability"] = number(diagnosis.knownProbability);
  j["next_motion"] = diagnosis.nextMotion;
  j["windows"] = diagnosis.windows;
  j["held_out_windows"] = diagnosis.leftOutWindows;
  return j.dump(1);
}

}  // namespace plumbline::gap
