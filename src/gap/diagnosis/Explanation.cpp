#include "gap/diagnosis/Explanation.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <filesystem>

namespace plumbline::gap {

std::string describe(const Cause& cause) {
  char number[32];
  std::snprintf(number, sizeof number, "%.3g", cause.value);
  std::string text = std::string(cause.effect->id) + " at " + cause.place.at;
  if (cause.place.axis) text += std::string(" about ") + cause.place.axis;
  text += std::string(" = ") + number;
  if (cause.effect->unit != "1") text += " " + std::string(cause.effect->unit);
  return text;
}

std::string describeInactiveIn(const Cause& cause) {
  if (cause.inactiveIn.empty()) return "";
  std::string names;
  for (const std::string& recording : cause.inactiveIn) {
    const std::filesystem::path folder(recording);
    names += (names.empty() ? "" : ", ") +
             (folder.has_filename() ? folder : folder.parent_path()).filename().string();
  }
  return "not set in " + names;
}

bool withinEngines(const Cause& cause) {
  const Effect& effect = *cause.effect;
  return std::abs(cause.value - effect.nominal) < effect.engineShare * effect.nominal;
}

bool doesNothing(const Mechanism& mechanism, const Cause& cause) {
  constexpr double part = 1e-4;  // of the least strength that a search starts from
  const Effect& effect = *cause.effect;
  const double scale = effect.scaleAt(mechanism, cause.place);
  const auto strength = [&](double value) { return std::abs(effect.strengthOf(value)); };
  double least = INFINITY;
  for (const double start : effect.starts) least = std::min(least, strength(start * scale));
  return strength(cause.value) < part * least;
}

bool ofSensor(const Cause& cause) { return cause.place.site == Site::imu || cause.place.site == Site::foot; }

bool losesCommands(const Explanation& causes) {
  return std::ranges::any_of(causes, [](const Cause& cause) { return cause.effect->decoded; });
}

Explanation without(Explanation causes, std::size_t i) {
  causes.erase(causes.begin() + static_cast<std::ptrdiff_t>(i));
  return causes;
}

int mostAtOneJoint(const Explanation& causes) {
  std::ptrdiff_t most = 1;
  for (const Cause& cause : causes)
    if (cause.place.site == Site::joint)
      most = std::max(most, std::ranges::count(causes, cause.place, &Cause::place));
  return static_cast<int>(most);
}

Plant plantOf(const Mechanism& mechanism, const Explanation& causes) {
  Plant plant = nominalPlant(mechanism);
  for (const Cause& cause : causes) cause.effect->apply(plant, cause.place, cause.value, cause.variant);
  return plant;
}

Plant plantOf(const Trial& trial, const Explanation& causes) {
  Plant plant = nominalPlant(*trial.robot);
  for (const Cause& cause : causes)
    if (inForce(cause, trial)) cause.effect->apply(plant, cause.place, cause.value, cause.variant);
  return plant;
}

bool inForce(const Cause& cause, const Trial& trial) {
  return std::ranges::find(cause.inactiveIn, trial.recording) == cause.inactiveIn.end();
}

std::size_t inactiveAmong(const Cause& cause, const std::vector<std::string>& recordings) {
  return static_cast<std::size_t>(std::ranges::count_if(recordings, [&](const std::string& recording) {
    return std::ranges::find(cause.inactiveIn, recording) != cause.inactiveIn.end();
  }));
}

bool isExpectedElsewhere(const Cause& cause, const std::vector<std::string>& recordings) {
  return 2 * inactiveAmong(cause, recordings) <= recordings.size();
}

}  // namespace plumbline::gap
