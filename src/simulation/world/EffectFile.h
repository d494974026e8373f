#pragma once
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "framework/ConfigSection.h"

namespace plumbline::simulation {

/// One effect that is added to a simulator: id, place and unit of the value as the gap
/// tool's contract has them (doc/reference/effects-file.md).
struct EffectSetting {
  std::string effect, at;
  std::string axis;  ///< "x", "y", "z"; empty where the effect has none
  double value = 0;
  std::string variant;  ///< in words, where an effect can be built in more ways than one; empty: the first
  std::string origin;   ///< where it was written, if not in a file of effects
  std::optional<ConfigSection> source;  ///< its place in a file of effects

  /// Throws ConfigurationError: `FILE:LINE: KEY MESSAGE`, or `ORIGIN: KEY MESSAGE`.
  [[noreturn]] void fail(std::string_view key, const std::string& message) const;
};

/// Reads a file of effects, or an answer of bin/gap diagnose (JSON), in order. Only its form is checked here:
/// what ids and places there are depends on the robot. Throws ConfigurationError.
std::vector<EffectSetting> readEffects(const std::string& path);

/// The file that reads as these settings (`source` aside), with a comment on top, each line of it after a #.
std::string effectsText(const std::vector<EffectSetting>& effects, const std::string& comment);

}  // namespace plumbline::simulation
