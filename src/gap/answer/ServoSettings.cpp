#include "gap/answer/ServoSettings.h"

#include <fmt/format.h>
#include <algorithm>
#include <nlohmann/json.hpp>

namespace plumbline::gap {

namespace {

std::vector<std::pair<std::string, double>> settingsOf(const Servo& servo) {
  if (servo.model == Servo::Model::dcMotor) return {{"kp_firmware", servo.kpFirmware}, {"vin", servo.vin}};
  return {{"kp", servo.kp}, {"kd", servo.kd}};
}

std::string text(const ServoSettings::Range& range) {
  return range.most > range.least ? fmt::format("{:.4g} to {:.4g}", range.least, range.most)
                                  : fmt::format("{:.4g}", range.least);
}

}  // namespace

ServoSettings servoSettings(const std::vector<Trial>& trials) {
  ServoSettings settings;
  for (const Trial& trial : trials)
    for (std::size_t j = 0; j < trial.command.size(); ++j) {
      if (trial.command[j].empty()) continue;
      const Mechanism::Joint& joint = trial.robot->joints[j];
      for (const auto& [name, value] : settingsOf(joint.servo)) {
        auto& ranges = settings.ofJoint[joint.name];
        const auto [at, fresh] = ranges.try_emplace(name, ServoSettings::Range{value, value});
        if (!fresh) at->second = {std::min(at->second.least, value), std::max(at->second.most, value)};
      }
    }
  return settings;
}

nlohmann::json settingsJson(const ServoSettings& settings) {
  nlohmann::json json = nlohmann::json::object();
  for (const auto& [joint, ranges] : settings.ofJoint)
    for (const auto& [name, range] : ranges) json[joint][name] = {range.least, range.most};
  return json;
}

ServoSettings settingsIn(const nlohmann::json& json) {
  ServoSettings settings;
  if (!json.is_object()) return settings;
  for (const auto& [joint, ranges] : json.items()) {
    if (!ranges.is_object()) continue;
    for (const auto& [name, range] : ranges.items())
      if (range.is_array() && range.size() == 2 && range[0].is_number() && range[1].is_number())
        settings.ofJoint[joint][name] = {range[0].get<double>(), range[1].get<double>()};
  }
  return settings;
}

std::vector<std::string> settingsBeyond(const ServoSettings& others, const std::vector<Trial>& trials) {
  std::vector<std::string> lines;
  for (const auto& [joint, ranges] : servoSettings(trials).ofJoint) {
    const auto known = others.ofJoint.find(joint);
    if (known == others.ofJoint.end()) continue;
    for (const auto& [name, here] : ranges) {
      const auto range = known->second.find(name);
      if (range == known->second.end()) continue;
      if (here.least >= range->second.least && here.most <= range->second.most) continue;
      lines.push_back(fmt::format("{} of {} is {} here, and {} in the recordings of the answer", name, joint,
                                  text(here), text(range->second)));
    }
  }
  return lines;
}

}  // namespace plumbline::gap
