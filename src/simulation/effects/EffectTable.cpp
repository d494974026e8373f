#include "simulation/effects/EffectTable.h"

#include <algorithm>
#include <cctype>
#include <cstdio>
#include <string_view>

#include "framework/NearestName.h"
#include "simspark/LeagueRobots.h"

namespace plumbline::simulation {

namespace {

enum class Site { everywhere, joint, jointOrEverywhere, link, imu, foot, ground };

struct Known {
  std::string_view id;
  Site site;
  bool hasAxis;
  double lower, upper;
};

constexpr Known known[] = {{"command_delay", Site::jointOrEverywhere, false, 0, 1},
                           {"command_dropout", Site::everywhere, false, 0, 1},
                           {"servo_gain", Site::joint, false, 0, 10},
                           {"torque_limit", Site::jointOrEverywhere, false, 0, 10},
                           {"speed_limit", Site::jointOrEverywhere, false, 0, 10},
                           {"supply_voltage", Site::everywhere, false, 0, 3},
                           {"coulomb_friction", Site::joint, false, 0, 10},
                           {"backlash", Site::joint, false, 0, 0.5},
                           {"acceleration_limit", Site::joint, false, 1e-3, 1e6},
                           {"profile_speed", Site::jointOrEverywhere, false, 1e-3, 1e3},
                           {"joint_offset", Site::joint, false, -0.5, 0.5},
                           {"encoder_nonlinearity", Site::joint, false, -0.5, 0.5},
                           {"link_mass", Site::link, false, -5, 10},
                           {"com_offset", Site::link, true, -0.2, 0.2},
                           {"imu_misalignment", Site::imu, true, -3.2, 3.2},
                           {"gyro_bias", Site::imu, true, -10, 10},
                           {"imu_delay", Site::imu, false, 0, 1},
                           {"fsr_gain", Site::foot, false, 0, 10},
                           {"ground_friction", Site::ground, false, 0, 10},
                           {"ground_slope", Site::ground, true, -0.5, 0.5},
                           {"ground_compliance", Site::ground, false, 1e-9, 1e-2}};

bool same(std::string_view a, std::string_view b) {
  return std::ranges::equal(a, b, [](char x, char y) {
    return std::tolower(static_cast<unsigned char>(x)) == std::tolower(static_cast<unsigned char>(y));
  });
}

bool isLink(const std::string& name) {
  for (const RobotModel& robot : simsparkRobots())
    for (const Link& link : robot.links)
      if (same(link.name, name)) return true;
  return false;
}

/// What there is in place of a name that is not known; empty for one that is.
std::string wrongPlace(const Known& effect, const std::string& at) {
  const bool joint =
      std::ranges::any_of(humanoidJointNames, [&](std::string_view name) { return same(name, at); });
  switch (effect.site) {
    case Site::everywhere:
      return at == "*" ? "" : "\"*\"";
    case Site::joint:
      return joint ? "" : "a joint such as LKneePitch";
    case Site::jointOrEverywhere:
      return joint || at == "*" ? "" : "\"*\" or a joint such as LKneePitch";
    case Site::link:
      return isLink(at) ? "" : "a link such as torso or lThigh";
    case Site::imu:
      return at == "imu" ? "" : "imu";
    case Site::foot:
      return same(at, "lFoot") || same(at, "rFoot") || same(at, "lToe") || same(at, "rToe")
                 ? ""
                 : "lFoot, rFoot, lToe or rToe";
    case Site::ground:
      return at == "ground" ? "" : "ground";
  }
  return "";
}

/// `; did you mean "x"?` for what sits at joints.
std::string nearestJoint(const Known& effect, const std::string& at) {
  if (effect.site != Site::joint && effect.site != Site::jointOrEverywhere) return "";
  return suggestion(at, {humanoidJointNames.begin(), humanoidJointNames.end()});
}

std::string text(double x) {
  char number[32];
  std::snprintf(number, sizeof number, "%g", x);
  return number;
}

void check(const EffectSetting& setting) {
  const auto* effect = std::ranges::find(known, std::string_view(setting.effect), &Known::id);
  if (effect == std::end(known)) {
    std::string list;
    for (const Known& k : known) list += (list.empty() ? "" : ", ") + std::string(k.id);
    setting.fail("effect",
                 "is \"" + setting.effect + "\", which the league's robots cannot have; there is " + list);
  }
  if (const std::string places = wrongPlace(*effect, setting.at); !places.empty())
    setting.fail("at", "is \"" + setting.at + "\"; " + setting.effect + " sits at " + places +
                           nearestJoint(*effect, setting.at));
  if (effect->hasAxis && setting.axis.empty())
    setting.fail("effect", "is " + setting.effect + ", which needs an axis: x, y or z");
  if (!effect->hasAxis && !setting.axis.empty())
    setting.fail("axis", "is given, and " + setting.effect + " has none");
  if (effect->site == Site::ground && setting.axis == "z")
    setting.fail("axis", "is z; a slope is about x or y");
  if (setting.value < effect->lower || setting.value > effect->upper)
    setting.fail("value", "is " + text(setting.value) + "; " + setting.effect + " goes from " +
                              text(effect->lower) + " to " + text(effect->upper));
}

}  // namespace

void checkEffects(const std::vector<EffectSetting>& effects) { std::ranges::for_each(effects, check); }

bool isAt(const EffectSetting& effect, JointId joint) {
  return effect.at == "*" || (joint < numHumanoidJoints && same(effect.at, humanoidJointNames[joint]));
}

bool isAt(const EffectSetting& effect, const Link& link) { return same(effect.at, link.name); }

}  // namespace plumbline::simulation
