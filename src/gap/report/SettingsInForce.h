#pragma once
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "gap/diagnosis/Explanation.h"
#include "gap/replay/Replay.h"
#include "gap/replay/Trial.h"

namespace plumbline::gap {

/// A setting that some recordings of an answer lacked (`not_in`), with and without which others are replayed.
struct SettingChoice {
  std::string effect;
  bool expected = true;  ///< in force in recordings that the answer did not see
  Explanation with, without;
};

/// Of each such setting of an answer. replayed: what the answer expects (replayedSettingsOf). Throws
/// ConfigurationError where the robot or the library does not have an effect.
std::vector<SettingChoice> settingChoices(const nlohmann::json& answer, const std::string& path,
                                          const Mechanism& robot, const Explanation& replayed);

/// What a recording leaves with and without a setting: root mean squares of its positions [rad, or m].
struct SettingSeen {
  std::string folder, effect;
  bool expected = true;
  double with = 0, without = 0;

  bool isNearerWith() const { return with <= without; }
  static constexpr double clearlyMore = 1.1;
  /// What is expected leaves clearly more than the other.
  bool isUnexpected() const { return expected ? with > clearlyMore * without : without > clearlyMore * with; }
  /// For people: "multisine: with acceleration_limit 15.5 mrad are left, without it 3.5: ...".
  std::string sentence() const;
};

/// nominal: the replay of the nominal model. expectedLeft: what the answer's expectation leaves [rad, or m].
std::vector<SettingSeen> settingsSeen(const Trial& trial, const Prediction& nominal, double expectedLeft,
                                      const std::vector<SettingChoice>& choices);

}  // namespace plumbline::gap
