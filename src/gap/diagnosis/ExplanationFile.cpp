#include "gap/diagnosis/ExplanationFile.h"

#include <algorithm>
#include <cstdio>
#include <stdexcept>

#include "framework/NearestName.h"

namespace plumbline::gap {

namespace {

std::string text(double value) {
  char number[32];
  std::snprintf(number, sizeof number, "%.4g", value);
  return number;
}

Cause causeOf(const simulation::EffectSetting& setting, const Mechanism& robot) {
  Cause cause;
  cause.effect = findEffect(setting.effect);
  if (!cause.effect) {
    std::vector<std::string> names;
    for (const Effect* effect : effects()) names.emplace_back(effect->id);
    setting.fail("effect", "is \"" + setting.effect + "\"; the library has no such effect" +
                               suggestion(setting.effect, names));
  }
  try {
    cause.place = findPlace(*cause.effect, robot, setting.at, setting.axis);
  } catch (const std::invalid_argument& error) {
    setting.fail("at", std::string("does not fit: ") + error.what());
  }
  const auto [lower, upper] = cause.effect->boundsAt(robot, cause.place);
  const double rounding = 1e-5 * (upper - lower);  // answers have six digits
  if (setting.value < lower - rounding || setting.value > upper + rounding)
    setting.fail("value", "is " + text(setting.value) + "; " + setting.effect + " goes from " + text(lower) +
                              " to " + text(upper) + " " + std::string(cause.effect->unit));
  cause.value = setting.value;
  if (!setting.variant.empty()) {
    const auto& variants = cause.effect->variants;
    const auto found = std::ranges::find(variants, setting.variant);
    if (found == variants.end()) {
      std::string known;
      for (const std::string_view variant : variants)
        known += (known.empty() ? "\"" : ", \"") + std::string(variant) + "\"";
      setting.fail("variant", known.empty()
                                  ? "has no meaning: " + setting.effect + " has only one form; leave it out"
                                  : "must be one of " + known);
    }
    cause.variant = static_cast<int>(found - variants.begin());
  }
  return cause;
}

}  // namespace

Explanation causesOf(const std::vector<simulation::EffectSetting>& settings, const Mechanism& robot) {
  Explanation causes;
  for (const simulation::EffectSetting& setting : settings) causes.push_back(causeOf(setting, robot));
  return causes;
}

std::vector<simulation::EffectSetting> settingsOf(const Explanation& causes) {
  std::vector<simulation::EffectSetting> settings;
  for (const Cause& cause : causes) {
    simulation::EffectSetting setting;
    setting.effect = cause.effect->id;
    setting.at = cause.place.at;
    if (cause.place.axis) setting.axis = cause.place.axis;
    setting.value = cause.value;
    if (cause.variant > 0) setting.variant = cause.effect->variants[static_cast<std::size_t>(cause.variant)];
    settings.push_back(setting);
  }
  return settings;
}

}  // namespace plumbline::gap
