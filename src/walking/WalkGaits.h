#pragma once
#include <array>
#include <string>
#include <utility>
#include <vector>

#include "math/Types.h"
#include "walking/WalkParameters.h"

namespace plumbline::walking {

/// The walk's parameters over its speeds: one set up to the speeds that may be mixed
/// (WalkParameters::mixForward
/// ..), and one for full speed in each direction. What lies between is blended linearly, so one walk may be
/// quick forward and another quick in turning.
struct WalkGaits {
  static constexpr std::size_t numCorners = 4;
  static constexpr std::array<const char*, numCorners> cornerNames{"forward", "backward", "sideways", "turn"};

  WalkParameters base;
  std::array<WalkParameters, numCorners> corner;
  /// What is different while the robot recovers from a push, whatever it was doing.
  std::vector<std::pair<const WalkParameterInfo*, double>> recovery;

  WalkGaits() = default;
  /// The same at all speeds.
  explicit WalkGaits(const WalkParameters& all) : base(all) { corner.fill(all); }

  /// The parameters at a velocity [m/s, rad/s]; those that hold for the whole walk (WalkParameterInfo::blends
  /// false) are the base's. recovering: share of what is different in recovery, 0 .. 1.
  WalkParameters at(const Vec2& velocity, double turn, double recovering = 0) const;

  /// Throws std::invalid_argument for the first parameter out of its range, corners with their name before
  /// it.
  void check() const;
};

/// Reads gaits from a section of a config file (framework/ConfigSection.h, or what has its get and find):
/// every parameter must be there; below a key "forward", "backward", "sideways" or "turn" stands what is
/// different at full speed in that direction, below "recovery" what is while recovering. Errors are the
/// section's.
template <class Section>
WalkGaits readWalkGaits(const Section& file) {
  WalkParameters base;
  for (const WalkParameterInfo& info : walkParameterTable())
    base.*info.value = file.template get<double>(info.name, {info.low, info.high});
  WalkGaits gaits(base);
  for (std::size_t i = 0; i < WalkGaits::numCorners; ++i)
    for (const WalkParameterInfo& info : walkParameterTable()) {
      if (!info.blends) continue;
      const std::string key = std::string(WalkGaits::cornerNames[i]) + '.' + info.name;
      if (const auto value = file.template find<double>(key, {info.low, info.high}))
        gaits.corner[i].*info.value = *value;
    }
  for (const WalkParameterInfo& info : walkParameterTable()) {
    if (!info.blends) continue;
    if (const auto value =
            file.template find<double>(std::string("recovery.") + info.name, {info.low, info.high}))
      gaits.recovery.emplace_back(&info, *value);
  }
  return gaits;
}

}  // namespace plumbline::walking
