#pragma once
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "gap/diagnosis/Explanation.h"
#include "simulation/world/EffectFile.h"

namespace plumbline::gap {

/// The effects that an answer (as readAnswer checked it) found, as settings of a simulator.
std::vector<simulation::EffectSetting> settingsOf(const nlohmann::json& answer, const std::string& path);

/// Another cause that an answer names beside one of its effects.
struct AnswerRival {
  std::size_t effect = 0;  ///< index of the effect it would replace
  Cause cause;
  double probability = 0;
};

/// What an answer found, for one robot.
struct AnswerCauses {
  Explanation causes;
  std::vector<std::pair<double, double>> intervals;  ///< of the values; equal ends where the answer has none
  std::vector<double> probabilities;
  std::vector<AnswerRival> rivals;  ///< the most probable first
};

/// Throws ConfigurationError that names file and effect, where the robot or the library has no such thing.
AnswerCauses causesOf(const nlohmann::json& answer, const std::string& path, const Mechanism& robot);

}  // namespace plumbline::gap
