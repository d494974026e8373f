#pragma once
#include <array>
#include <string>

#include "math/Types.h"
#include "walking/parameters/WalkParameters.h"

namespace plumbline::walking {

/// The walk's parameters over its speeds: one set up to the omnidirectional limits (speed.omniForward ..),
/// and one for full speed in each direction. What lies between is blended linearly, so one walk may be quick
/// forward and another quick in turning.
struct WalkGaits {
  static constexpr std::size_t numCorners = 4;
  static constexpr std::array<const char*, numCorners> cornerNames{"forward", "backward", "sideways", "turn"};

  WalkParameters base;
  std::array<WalkParameters, numCorners> corner;
  /// What is different while the robot recovers from a push, whatever it was doing; not a number: nothing.
  WalkParameters recovery;

  WalkGaits() : WalkGaits(WalkParameters{}) {}
  /// The same at all speeds.
  explicit WalkGaits(const WalkParameters& all);

  /// The parameters by the paths that they have in walking.yaml: "step.duration" of the base,
  /// "gaits.forward.step.duration", "gaits.recovery.step.duration" of those that blend.
  static const ParameterList& parameterList();

  /// The parameters at a velocity [m/s, rad/s]; those without the attribute "blends" hold for the whole walk
  /// and are the base's. recovering: share of what is different in recovery, 0 .. 1.
  WalkParameters at(const Vec2& velocity, double turn, double recovering = 0) const;

  /// Gives a parameter of the base another value; corners that had the same follow it.
  void setBase(const WalkParameter& parameter, double value);
  /// The robot does nothing else while it recovers.
  void clearRecovery();
  /// In open loop: nothing measured has an effect (attribute "feedback").
  void openLoop();

  /// Throws std::invalid_argument for the first parameter out of its range, corners with their name before
  /// it.
  void check() const;
};

/// Reads gaits from a section of a config file (framework/ConfigSection.h, or what has its find): what is not
/// there keeps its default; in a direction below "gaits" what is not there is the base's. Errors are the
/// section's.
template <class Section>
WalkGaits readWalkGaits(const Section& file) {
  const auto read = [&](const std::string& prefix, bool gait, WalkParameters& values) {
    for (const WalkParameter& one : walkParameters()) {
      if (gait && !one.blends) continue;
      if (const auto value = file.template find<double>(prefix + one.path, one.declared->range))
        one.of(values) = *value;
    }
  };
  WalkParameters base;
  read("", false, base);
  WalkGaits gaits(base);
  for (std::size_t i = 0; i < WalkGaits::numCorners; ++i)
    read(std::string("gaits.") + WalkGaits::cornerNames[i] + ".", true, gaits.corner[i]);
  read("gaits.recovery.", true, gaits.recovery);
  return gaits;
}

}  // namespace plumbline::walking
