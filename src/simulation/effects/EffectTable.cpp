#include "simulation/effects/EffectTable.h"

#include <algorithm>
#include <cstdio>

#include "framework/NearestName.h"
#include "simspark/LeagueRobots.h"
#include "simulation/effects/EffectPlace.h"
#include "simulation/effects/LeagueEffect.h"

namespace plumbline::simulation {

namespace {

using Site = LeagueEffect::Site;

bool isLink(const std::string& name) {
  for (const RobotModel& robot : simsparkRobots())
    for (const Link& link : robot.links)
      if (samePlace(link.name, name)) return true;
  return false;
}

/// The existing names, for a name that is unknown; empty for a known one.
std::string wrongPlace(const LeagueEffect& effect, const std::string& at) {
  const bool joint =
      std::ranges::any_of(humanoidJointNames, [&](std::string_view name) { return samePlace(name, at); });
  const auto isOneOf = [&](auto... names) { return (samePlace(at, names) || ...); };
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
      return isOneOf("lFoot", "rFoot", "lToe", "rToe") ? "" : "lFoot, rFoot, lToe or rToe";
    case Site::ground:
      return at == "ground" ? "" : "ground";
  }
  return "";
}

/// `; did you mean "x"?` for what sits at joints.
std::string nearestJoint(const LeagueEffect& effect, const std::string& at) {
  if (effect.site != Site::joint && effect.site != Site::jointOrEverywhere) return "";
  return suggestion(at, {humanoidJointNames.begin(), humanoidJointNames.end()});
}

std::string text(double x) {
  char number[32];
  std::snprintf(number, sizeof number, "%g", x);
  return number;
}

/// "x, y or z"
std::string listed(std::string_view axes) {
  std::string list;
  for (std::size_t i = 0; i < axes.size(); ++i)
    list += (i == 0 ? "" : i + 1 == axes.size() ? " or " : ", ") + std::string(1, axes[i]);
  return list;
}

void check(const EffectSetting& setting) {
  const LeagueEffect* effect = findLeagueEffect(setting.effect);
  if (effect == nullptr) {
    std::string list;
    for (const LeagueEffect* known : leagueEffects())
      list += (list.empty() ? "" : ", ") + std::string(known->id);
    setting.fail("effect",
                 "is \"" + setting.effect + "\", which the league's robots cannot have; there is " + list);
  }
  if (const std::string places = wrongPlace(*effect, setting.at); !places.empty())
    setting.fail("at", "is \"" + setting.at + "\"; " + setting.effect + " sits at " + places +
                           nearestJoint(*effect, setting.at));
  if (!effect->axes.empty() && setting.axis.empty())
    setting.fail("effect", "is " + setting.effect + ", which needs an axis: " + listed(effect->axes));
  if (effect->axes.empty() && !setting.axis.empty())
    setting.fail("axis", "is given, and " + setting.effect + " has none");
  if (!setting.axis.empty() && effect->axes.find(setting.axis) == std::string_view::npos)
    setting.fail("axis", "is " + setting.axis + "; " + setting.effect + " is about " + listed(effect->axes));
  if (setting.value < effect->lower || setting.value > effect->upper)
    setting.fail("value", "is " + text(setting.value) + "; " + setting.effect + " goes from " +
                              text(effect->lower) + " to " + text(effect->upper));
}

}  // namespace

void checkEffects(const std::vector<EffectSetting>& effects) { std::ranges::for_each(effects, check); }

}  // namespace plumbline::simulation
