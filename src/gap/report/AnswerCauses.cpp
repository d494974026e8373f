#include "gap/report/AnswerCauses.h"

#include <algorithm>
#include <nlohmann/json.hpp>

#include "framework/ConfigurationError.h"
#include "gap/diagnosis/ExplanationFile.h"

namespace plumbline::gap {

namespace {

using nlohmann::json;

std::string textOf(const json& map, const char* key) {
  return map.contains(key) && map[key].is_string() ? map[key].get<std::string>() : std::string();
}

double numberOf(const json& map, const char* key, double fallback) {
  return map.contains(key) && map[key].is_number() ? map[key].get<double>() : fallback;
}

simulation::EffectSetting settingOf(const json& cause, const std::string& origin) {
  simulation::EffectSetting setting;
  setting.effect = textOf(cause, "effect");
  setting.at = textOf(cause, "at");
  setting.axis = textOf(cause, "axis");
  setting.value = numberOf(cause, "value", 0);
  setting.variant = textOf(cause, "variant");
  setting.origin = origin;
  return setting;
}

std::vector<simulation::EffectSetting> settingsIn(const json& causes, const std::string& name) {
  std::vector<simulation::EffectSetting> settings;
  for (const json& cause : causes)
    settings.push_back(settingOf(cause, name + "[" + std::to_string(settings.size()) + "]"));
  return settings;
}

/// The list of causes at a place of an answer; empty where there is none.
json modelAt(const json& answer, const char* place) {
  const json::json_pointer pointer(place);
  const json model = answer.contains(pointer) ? answer.at(pointer) : json();
  return model.is_array() ? model : json::array();
}

std::vector<simulation::EffectSetting> modelSettings(const json& model, const std::string& name) {
  for (std::size_t i = 0; i < model.size(); ++i)
    if (const json& cause = model[i]; !cause.is_object() || textOf(cause, "effect").empty() ||
                                      textOf(cause, "at").empty() || !cause.contains("value") ||
                                      !cause["value"].is_number())
      throw ConfigurationError(name + "[" + std::to_string(i) +
                               "]: lacks 'effect', 'at' or a number 'value'");
  return settingsIn(model, name);
}

}  // namespace

std::vector<simulation::EffectSetting> settingsOf(const json& answer, const std::string& path) {
  return settingsIn(answer["effects"], path + ": effects");
}

std::vector<simulation::EffectSetting> furtherSettingsOf(const json& answer, const std::string& path) {
  const json model = modelAt(answer, "/gap/further/model");
  if (model.empty())
    throw ConfigurationError(path +
                             ": has no values of all joints (gap.further.model); answers with the verdict "
                             "unknown about robots whose base is fixed have them");
  return modelSettings(model, path + ": gap.further.model");
}

std::vector<simulation::EffectSetting> replayedSettingsOf(const json& answer, const std::string& path) {
  const json model = modelAt(answer, "/gap/model");
  if (!model.empty()) return modelSettings(model, path + ": gap.model");
  std::vector<simulation::EffectSetting> settings = settingsOf(answer, path), expected;
  for (std::size_t i = 0; i < settings.size(); ++i)
    if (const json& effect = answer["effects"][i];
        !effect.contains("expected_elsewhere") || effect["expected_elsewhere"] != false)
      expected.push_back(std::move(settings[i]));
  return expected;
}

AnswerCauses causesOf(const json& answer, const std::string& path, const Mechanism& robot) {
  AnswerCauses result;
  result.causes = causesOf(settingsOf(answer, path), robot);
  std::size_t i = 0;
  for (const json& cause : answer["effects"]) {
    const double value = result.causes[i].value;
    result.probabilities.push_back(numberOf(cause, "probability", 1));
    result.intervals.emplace_back(value, value);
    if (cause.contains("interval") && cause["interval"].is_array() && cause["interval"].size() == 2 &&
        cause["interval"][0].is_number() && cause["interval"][1].is_number())
      result.intervals.back() = {cause["interval"][0], cause["interval"][1]};
    if (cause.contains("confounded_with"))
      for (const json& rival : cause["confounded_with"]) {
        simulation::EffectSetting setting =
            settingOf(rival, path + ": effects[" + std::to_string(i) + "].confounded_with");
        if (const Effect* effect = findEffect(setting.effect); effect && !rival.contains("value"))
          setting.value = effect->starts.front();
        result.rivals.push_back(
            {i, causesOf(std::vector{setting}, robot).front(), numberOf(rival, "probability", 0)});
      }
    ++i;
  }
  std::ranges::stable_sort(result.rivals, std::ranges::greater(), &AnswerRival::probability);
  return result;
}

}  // namespace plumbline::gap
