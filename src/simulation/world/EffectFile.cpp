#include "simulation/world/EffectFile.h"

#include <cstdio>
#include <sstream>

#include "framework/ConfigFile.h"
#include "framework/ConfigurationError.h"

namespace plumbline::simulation {

void EffectSetting::fail(std::string_view key, const std::string& message) const {
  if (source) source->fail(key, message);
  throw ConfigurationError(origin + ": " + std::string(key) + " " + message);
}

namespace {

/// A text in double quotes as YAML reads it.
std::string quoted(const std::string& text) {
  std::string result = "\"";
  for (const char c : text) {
    if (c == '"' || c == '\\') result += '\\';
    result += static_cast<unsigned char>(c) < ' ' ? ' ' : c;
  }
  return result + '"';
}

}  // namespace

std::vector<EffectSetting> readEffects(const std::string& path) {
  constexpr std::size_t most = 1000;
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
    if (effects.size() > most) entry.fail("effect", "is one of more than 1000 effects");
  }
  file.checkUnknown();
  return effects;
}

std::string effectsText(const std::vector<EffectSetting>& effects, const std::string& comment) {
  std::string text;
  std::istringstream lines(comment);
  for (std::string line; std::getline(lines, line);) text += "# " + line + "\n";
  text += effects.empty() ? "effects: []\n" : "effects:\n";
  for (const EffectSetting& effect : effects) {
    char value[32];
    std::snprintf(value, sizeof value, "%.10g", effect.value);
    text += "  - {effect: " + quoted(effect.effect) + ", at: " + quoted(effect.at);
    if (!effect.axis.empty()) text += ", axis: " + quoted(effect.axis);
    text += std::string(", value: ") + value;
    if (!effect.variant.empty()) text += ", variant: " + quoted(effect.variant);
    text += "}\n";
  }
  return text;
}

}  // namespace plumbline::simulation
