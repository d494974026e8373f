#pragma once
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "gap/diagnosis/Explanation.h"
#include "simulation/world/EffectFile.h"

namespace plumbline::gap {

/// The effects that an answer (as readAnswer checked it) found, as settings of a simulator.
std::vector<simulation::EffectSetting> settingsOf(const nlohmann::json& answer, const std::string& path);

/// What the answer replays to close the gap in other recordings: its causes with their values in each joint
/// (gap.model) if it has such, else its effects; without settings that most recordings lacked. Throws
/// ConfigurationError where one lacks effect, place or value.
std::vector<simulation::EffectSetting> replayedSettingsOf(const nlohmann::json& answer,
                                                          const std::string& path);

/// The values of all joints that an answer fitted at once (gap.further). Throws ConfigurationError where
/// there are none, or one lacks effect, place or value.
std::vector<simulation::EffectSetting> furtherSettingsOf(const nlohmann::json& answer,
                                                         const std::string& path);

/// Another cause that an answer names as an alternative to one of its effects.
struct AnswerRival {
  std::size_t effect = 0;  ///< index of the effect it would replace
  Cause cause;
  double probability = 0;
};

/// The causes in an answer, for one robot.
struct AnswerCauses {
  Explanation causes;
  /// Of the values; both ends are equal if the answer has none.
  std::vector<std::pair<double, double>> intervals;
  std::vector<double> probabilities;
  std::vector<AnswerRival> rivals;  ///< the most probable first
};

/// Throws ConfigurationError that names file and effect, if the robot or the library does not have it.
AnswerCauses causesOf(const nlohmann::json& answer, const std::string& path, const Mechanism& robot);

}  // namespace plumbline::gap
