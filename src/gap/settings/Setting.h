#pragma once
#include <string>
#include <string_view>
#include <vector>

#include "simulation/world/World.h"

namespace plumbline::gap {

/// The embedded simulator as it explains recordings of the league's server.
struct SimulatorSetup {
  simulation::WorldConfig world;
  int delay = 1;        ///< cycles that a command waits beyond the one it is sent in
  double gain = 1;      ///< on commanded speeds
  double mass = 1;      ///< on all links' masses and inertias
  int stepsPerRow = 1;  ///< of the physics in 20 ms; world.stepSeconds must be what it makes them
};

/// One thing about the simulator that can be otherwise: a number or a switch.
struct Setting {
  std::string_view id, unit;
  std::string_view missing;  ///< what a simulator lacks that has it at `absent`, for people
  enum class Kind { positive, whole, onOff } kind = Kind::positive;
  double league = 0;  ///< the league server's own value, known from its source; a diagnosis never reads it
  double absent = 0;  ///< of a simulator that does not know of it
  double lower = 0, upper = 0;  ///< that a search looks between; positive ones on a logarithmic scale
  double (*get)(const SimulatorSetup&) = nullptr;
  void (*put)(SimulatorSetup&, double) = nullptr;
};

/// All settings that a diagnosis tries, those the league has by default and those it has not.
const std::vector<Setting>& settings();

/// Error: ConfigurationError that names the settings there are.
const Setting& findSetting(std::string_view id);

/// A setting at a value.
struct SettingValue {
  const Setting* setting = nullptr;
  double value = 0;
};

SimulatorSetup with(SimulatorSetup setup, const std::vector<SettingValue>& values);

/// "drag = 0.0101 N s/m"
std::string describe(const SettingValue& value);

/// Names of what --without takes: a setting, or a group of them that goes together (contact_softness).
std::vector<std::string> omissions();
/// The setup without that. Error: ConfigurationError naming those there are.
SimulatorSetup without(SimulatorSetup setup, const std::string& omission);
/// The settings that an omission takes away.
std::vector<std::string_view> settingsOf(const std::string& omission);

}  // namespace plumbline::gap
