#pragma once
#include <string>
#include <string_view>
#include <vector>

#include "simulation/world/World.h"

namespace plumbline::gap {

/// A setup of the embedded simulator, to explain recordings of the league's server.
struct SimulatorSetup {
  simulation::WorldConfig world;
  int delay = 1;        ///< cycles that a command waits after the one in which it is sent
  double gain = 1;      ///< on commanded speeds
  double mass = 1;      ///< on all links' masses and inertias
  int stepsPerRow = 1;  ///< of the physics in 20 ms; world.stepSeconds must fit
};

/// One property of the simulator that may differ: a number or a switch.
struct Setting {
  std::string_view id, unit;
  std::string_view missing;  ///< text: what a simulator with the value `absent` lacks
  enum class Kind { positive, whole, onOff } kind = Kind::positive;
  double league = 0;  ///< the league server's own value, known from its source; a diagnosis never reads it
  double absent = 0;  ///< value of a simulator without this property
  double lower = 0, upper = 0;  ///< range of a search; positive ones on a logarithmic scale
  double (*get)(const SimulatorSetup&) = nullptr;
  void (*put)(SimulatorSetup&, double) = nullptr;
};

/// All settings that a diagnosis tries, with and without a value on the league's server.
const std::vector<Setting>& settings();

/// Error: ConfigurationError that lists the existing settings.
const Setting& findSetting(std::string_view id);

/// A setting at a value.
struct SettingValue {
  const Setting* setting = nullptr;
  double value = 0;
};

SimulatorSetup with(SimulatorSetup setup, const std::vector<SettingValue>& values);

/// "drag = 0.0101 N s/m"
std::string describe(const SettingValue& value);

/// Names for --without: a setting, or a group of settings that belong together (contact_softness).
std::vector<std::string> omissions();
/// The setup without that. Error: ConfigurationError that lists the existing names.
SimulatorSetup without(SimulatorSetup setup, const std::string& omission);
/// The settings that an omission removes.
std::vector<std::string_view> settingsOf(const std::string& omission);

}  // namespace plumbline::gap
