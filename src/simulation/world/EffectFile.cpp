#include "simulation/world/EffectFile.h"

#include <cstdio>
#include <nlohmann/json.hpp>
#include <sstream>

#include "framework/CommentLines.h"
#include "framework/ConfigFile.h"
#include "framework/ConfigurationError.h"
#include "framework/Json.h"
#include "framework/ReadFile.h"
#include "framework/SingleLine.h"
#include "framework/YamlText.h"

namespace plumbline::simulation {

void EffectSetting::fail(std::string_view key, const std::string& message) const {
  // It quotes names from the file, which may hold line ends.
  const std::string line = singleLine(message);
  if (source) source->fail(key, line);
  throw ConfigurationError(origin + ": " + std::string(key) + " " + line);
}

namespace {

constexpr std::size_t mostEffects = 1000;

/// The effects of an answer of bin/gap diagnose.
std::vector<EffectSetting> effectsOfAnswer(const std::string& text, const std::string& path) {
  using nlohmann::json;
  const auto fail = [&](const std::string& what) -> void { throw ConfigurationError(path + ": " + what); };
  json answer;
  try {
    answer = parseJson(text, path);
  } catch (const JsonError& error) {
    throw ConfigurationError(error.what());
  }
  const auto textOf = [](const json& of, const char* key) {
    const auto found = of.find(key);
    return found != of.end() && found->is_string() ? found->get<std::string>() : std::string();
  };
  const std::string verdict = textOf(answer, "verdict");
  if (verdict == "unknown")
    fail(
        "the verdict is unknown, its effects are not the cause; bin/gap apply writes the nearest with "
        "--anyway, the values of all joints with --further");
  if (verdict != "effect" && verdict != "none")
    fail("is no answer of bin/gap diagnose: its verdict is neither none, effect nor unknown");
  std::vector<EffectSetting> effects;
  if (verdict == "none") return effects;
  if (!answer.contains("effects") || !answer["effects"].is_array()) fail("has no list of effects");
  for (const json& entry : answer["effects"]) {
    EffectSetting effect;
    effect.origin = path + ": effects[" + std::to_string(effects.size()) + "]";
    if (!entry.is_object() || textOf(entry, "effect").empty() || textOf(entry, "at").empty() ||
        !entry.contains("value") || !entry["value"].is_number())
      effect.fail("effect", "needs effect, at and value");
    effect.effect = textOf(entry, "effect");
    effect.at = textOf(entry, "at");
    effect.axis = textOf(entry, "axis");
    effect.value = entry["value"].get<double>();
    effect.variant = textOf(entry, "variant");
    effects.push_back(std::move(effect));
    if (effects.size() > mostEffects) fail("has more than 1000 effects");
  }
  return effects;
}

/// The file's text if it is JSON; nothing for YAML, and for a file that cannot be read, which the reader
/// reports.
std::optional<std::string> jsonIn(const std::string& path) {
  constexpr std::size_t most = std::size_t{64} << 20;
  std::string text;
  try {
    text = readFile(path, most);
  } catch (const FileProblem&) {
    return std::nullopt;
  }
  const std::size_t first = text.find_first_not_of(" \t\n\v\f\r");
  if (first == std::string::npos || text[first] != '{') return std::nullopt;
  return text;
}

}  // namespace

std::vector<EffectSetting> readEffects(const std::string& path) {
  if (const auto text = jsonIn(path)) return effectsOfAnswer(*text, path);
  const ConfigFile file(path);
  std::vector<EffectSetting> effects;
  for (const ConfigSection& entry : file.root().list("effects")) {
    EffectSetting effect;
    effect.effect = entry.get<std::string>("effect");
    effect.at = entry.get<std::string>("at");
    effect.axis = entry.find<std::string>("axis").value_or("");
    if (!effect.axis.empty() && effect.axis != "x" && effect.axis != "y" && effect.axis != "z")
      entry.fail("axis", "is \"" + effect.axis + "\" and must be x, y or z");
    effect.value = entry.get<double>("value", Range{-1e6, 1e6});
    effect.variant = entry.find<std::string>("variant").value_or("");
    effect.source = entry;
    effects.push_back(std::move(effect));
    if (effects.size() > mostEffects) entry.fail("effect", "is one of more than 1000 effects");
  }
  file.checkUnknown();
  return effects;
}

std::string effectsText(const std::vector<EffectSetting>& effects, const std::string& comment) {
  std::string text = commentLines(comment);
  text += effects.empty() ? "effects: []\n" : "effects:\n";
  for (const EffectSetting& effect : effects) {
    char value[32];
    std::snprintf(value, sizeof value, "%.10g", effect.value);
    text += "  - {effect: " + yamlText(effect.effect) + ", at: " + yamlText(effect.at);
    if (!effect.axis.empty()) text += ", axis: " + yamlText(effect.axis);
    text += std::string(", value: ") + value;
    if (!effect.variant.empty()) text += ", variant: " + yamlText(effect.variant);
    text += "}\n";
  }
  return text;
}

}  // namespace plumbline::simulation
