#include "gap/inference/JointValues.h"

#include <algorithm>
#include <cstdio>
#include <map>

#include "gap/effects/Effects.h"

namespace plumbline::gap {

namespace {

constexpr int rounds = 2, stepsOfFit = 6;
/// Per share of the squares that the causes leave. If those are some ten independent samples, standard
/// deviations of 3.2 and 5.8 of the least starts of a search: decision 17.
constexpr Shrinkage prior{.own = 1e-2, .common = 3e-3};

}  // namespace

bool differsByJoint(const Mechanism& robot, const Explanation& causes) {
  return robot.onlyMotor() < 0 && !kindsAtJoints(causes).empty();
}

Explanation withJointValues(const Replayer& replayer, const Explanation& causes) {
  const Mechanism& robot = replayer.mechanism();
  if (!differsByJoint(robot, causes)) return causes;
  PerJoint fitted = perJoint(robot, causes, kindsAtJoints(causes));
  fitted.left = shareLeft(replayer, causes);
  // The scale of the remainder is that of the last round.
  for (int round = 0; round < rounds; ++round) {
    const double left = fitted.left;
    fitted = fitPerJoint(replayer, std::move(fitted), stepsOfFit,
                         {.own = left * prior.own, .common = left * prior.common});
  }
  Explanation model = std::move(fitted.causes);
  std::erase_if(model, [&](const Cause& cause) { return doesNothing(robot, cause); });
  return model;
}

std::string jointValuesText(const Explanation& model) {
  std::map<const Effect*, std::vector<double>> perKind;
  std::vector<const Effect*> kinds;
  for (const Cause& cause : model) {
    if (cause.place.site != Site::joint) continue;
    if (!perKind.contains(cause.effect)) kinds.push_back(cause.effect);
    perKind[cause.effect].push_back(cause.value);
  }
  std::string text;
  for (const Effect* kind : kinds) {
    const std::vector<double>& of = perKind[kind];
    const auto [least, most] = std::ranges::minmax(of);
    char values[80];
    if (of.size() == 1)
      std::snprintf(values, sizeof values, "1 joint: %.3g", least);
    else
      std::snprintf(values, sizeof values, "%zu joints: %.3g to %.3g", of.size(), least, most);
    text += "  " + std::string(kind->id) + " in " + values;
    text += kind->unit == "1" ? "\n" : " " + std::string(kind->unit) + "\n";
  }
  return text;
}

}  // namespace plumbline::gap
