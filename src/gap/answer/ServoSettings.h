#pragma once
#include <map>
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "gap/replay/Trial.h"

namespace plumbline::gap {

/// Settings of servos over recordings: the least and the largest value of each, by joint and by its name in
/// run.json. Of commanded joints alone; those of a position servo are kp and kd, of a DC motor kp_firmware
/// and vin.
struct ServoSettings {
  struct Range {
    double least = 0, most = 0;
  };
  std::map<std::string, std::map<std::string, Range>> ofJoint;
};

ServoSettings servoSettings(const std::vector<Trial>& trials);

/// As a part of an answer, `{joint: {setting: [least, most]}}`, and read again; what is no such range is
/// passed over.
nlohmann::json settingsJson(const ServoSettings& settings);
ServoSettings settingsIn(const nlohmann::json& json);

/// Which settings of these recordings none of the others had, a line each for people: a claim about
/// recordings like the others does not cover them.
std::vector<std::string> settingsBeyond(const ServoSettings& others, const std::vector<Trial>& trials);

}  // namespace plumbline::gap
