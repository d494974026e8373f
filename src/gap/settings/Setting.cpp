#include "gap/settings/Setting.h"

#include <cmath>
#include <cstdio>

#include "framework/ConfigurationError.h"
#include "framework/NearestName.h"

namespace plumbline::gap {

namespace {

using Kind = Setting::Kind;
constexpr double endless = 1e4;

template <double simulation::LeaguePhysicsParameters::*number>
Setting numberSetting(std::string_view id, std::string_view unit, std::string_view missing, double absent,
                      double lower, double upper) {
  Setting s{id,     unit,  missing, Kind::positive, simulation::LeaguePhysicsParameters{}.*number,
            absent, lower, upper};
  s.get = [](const SimulatorSetup& setup) { return setup.world.numbers.*number; };
  s.put = [](SimulatorSetup& setup, double value) { setup.world.numbers.*number = value; };
  return s;
}

template <bool simulation::WorldConfig::*flag>
Setting flagSetting(std::string_view id, std::string_view missing) {
  const bool league = simulation::WorldConfig{}.*flag;
  Setting s{id, "", missing, Kind::onOff, league ? 1.0 : 0.0, 0, 0, 1};
  s.get = [](const SimulatorSetup& setup) { return setup.world.*flag ? 1.0 : 0.0; };
  s.put = [](SimulatorSetup& setup, double value) { setup.world.*flag = value != 0; };
  return s;
}

std::vector<Setting> makeSettings() {
  using N = simulation::LeaguePhysicsParameters;
  std::vector<Setting> list = {
      numberSetting<&N::drag>("drag", "N s/m", "a drag on every moving body", 0, 1e-4, 1),
      numberSetting<&N::contactSlip>("contact_slip", "m/(s N)", "a slip of loaded feet along the ground",
                                     1e-4, 1e-5, 1),
      numberSetting<&N::contactCfm>("contact_cfm", "s/kg", "a ground that gives under load", 1e-5, 1e-7,
                                    1e-1),
      numberSetting<&N::contactErp>("contact_erp", "1", "how fast the ground pushes out what sank into it",
                                    0.2, 0.02, 1),
      numberSetting<&N::jointCfm>("joint_cfm", "s/kg", "hinges that give under load", 0, 1e-8, 1e-2),
      numberSetting<&N::jointErp>("joint_erp", "1", "how fast hinges close their gaps", 0.2, 0.02, 1),
      numberSetting<&N::motorTorque>("motor_torque", "N m", "a limit to the motors' torque", endless, 0.5,
                                     200),
      flagSetting<&simulation::WorldConfig::bouncingJointStops>("bouncing_stops",
                                                                "joints that bounce off their stops"),
      flagSetting<&simulation::WorldConfig::selfCollision>("self_collision",
                                                           "limbs of a robot that touch each other"),
  };
  Setting delay{
      "action_delay", "cycles", "a cycle between a command and its effect", Kind::whole, 1, 0, 0, 3};
  delay.get = [](const SimulatorSetup& s) { return static_cast<double>(s.delay); };
  delay.put = [](SimulatorSetup& s, double v) { s.delay = static_cast<int>(std::lround(v)); };
  list.push_back(delay);
  Setting friction{"ground_friction",
                   "1",
                   "a limit to friction on the ground",
                   Kind::positive,
                   endless,
                   endless,
                   0.05,
                   10};
  friction.get = [](const SimulatorSetup& s) {
    return s.world.endlessFriction ? endless : s.world.frictionCoefficient;
  };
  friction.put = [](SimulatorSetup& s, double v) {
    s.world.endlessFriction = v >= endless;
    s.world.frictionCoefficient = v;
  };
  list.push_back(friction);
  Setting gain{"servo_gain", "1", "joints that turn at another speed than commanded", Kind::positive, 1, 1,
               0.5,          2};
  gain.get = [](const SimulatorSetup& s) { return s.gain; };
  gain.put = [](SimulatorSetup& s, double v) { s.gain = v; };
  list.push_back(gain);
  Setting mass{"mass", "1", "links of another mass", Kind::positive, 1, 1, 0.5, 2};
  mass.get = [](const SimulatorSetup& s) { return s.mass; };
  mass.put = [](SimulatorSetup& s, double v) { s.mass = v; };
  list.push_back(mass);
  return list;
}

const std::vector<std::pair<std::string, std::vector<std::string_view>>>& groups() {
  static const std::vector<std::pair<std::string, std::vector<std::string_view>>> all = {
      {"drag", {"drag"}},
      {"contact_slip", {"contact_slip"}},
      {"contact_softness", {"contact_cfm", "contact_erp"}},
      {"joint_softness", {"joint_cfm"}},
      {"motor_torque", {"motor_torque"}},
      {"action_delay", {"action_delay"}},
      {"bouncing_stops", {"bouncing_stops"}},
  };
  return all;
}

}  // namespace

const std::vector<Setting>& settings() {
  static const std::vector<Setting> all = makeSettings();
  return all;
}

const Setting& findSetting(std::string_view id) {
  std::vector<std::string> names;
  for (const Setting& setting : settings()) {
    if (setting.id == id) return setting;
    names.emplace_back(setting.id);
  }
  throw ConfigurationError("no setting " + std::string(id) + suggestion(std::string(id), names));
}

SimulatorSetup with(SimulatorSetup setup, const std::vector<SettingValue>& values) {
  for (const SettingValue& value : values) value.setting->put(setup, value.value);
  return setup;
}

std::string describe(const SettingValue& value) {
  const Setting& s = *value.setting;
  if (s.kind == Kind::onOff) return std::string(s.id) + (value.value != 0 ? " on" : " off");
  char number[32];
  std::snprintf(number, sizeof number, "%.3g", value.value);
  return std::string(s.id) + " = " + number + (s.unit == "1" ? "" : " " + std::string(s.unit));
}

std::vector<std::string> omissions() {
  std::vector<std::string> names;
  for (const auto& [name, ids] : groups()) names.push_back(name);
  return names;
}

std::vector<std::string_view> settingsOf(const std::string& omission) {
  std::string known;
  for (const auto& [name, ids] : groups()) {
    if (name == omission) return ids;
    known += (known.empty() ? "" : ", ") + name;
  }
  throw ConfigurationError("--without " + omission + ": unknown; choose one of " + known);
}

SimulatorSetup without(SimulatorSetup setup, const std::string& omission) {
  for (const std::string_view id : settingsOf(omission)) {
    const Setting& setting = findSetting(id);
    setting.put(setup, setting.absent);
  }
  return setup;
}

}  // namespace plumbline::gap
