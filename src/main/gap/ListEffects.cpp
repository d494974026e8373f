// bin/gap effects: the library, for people.
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <memory>
#include <string>

#include "gap/effects/Effects.h"
#include "main/gap/Commands.h"
#include "robot/MechanismFile.h"

namespace plumbline::gap {

namespace {

/// The widest bounds that an effect has at any place of a robot.
Bounds boundsOn(const Effect& effect, const Mechanism& robot) {
  Bounds widest{INFINITY, -INFINITY};
  for (const Place& place : placesOf(effect, robot)) {
    const Bounds bounds = effect.boundsAt(robot, place);
    widest.lower = std::min(widest.lower, bounds.lower);
    widest.upper = std::max(widest.upper, bounds.upper);
  }
  return widest;
}

void list(const Mechanism& robot) {
  std::printf("Values looked for on %s, at its strongest joint or anywhere.\n", robot.name.c_str());
  for (const Effect* effect : effects()) {
    const Bounds bounds = boundsOn(*effect, robot);
    const bool possible = bounds.lower <= bounds.upper;
    char range[64] = "no place on this robot";
    if (possible) std::snprintf(range, sizeof range, "%.3g to %.3g", bounds.lower, bounds.upper);
    std::printf("%-22s %-11s %s\n%35sShown by: %s\n%35sLooked for: %s\n", std::string(effect->id).c_str(),
                std::string(effect->unit).c_str(), std::string(effect->sentence).c_str(), "",
                std::string(effect->exposedBy).c_str(), "", range);
  }
}

}  // namespace

void addEffects(CommandLine& app) {
  CommandLine command = app.command("effects", "Lists the effects that a diagnosis knows");
  auto robot = std::make_shared<std::string>("nao_v5");
  command
      .option("--robot", *robot,
              "A name in config/robots, URDF or JSON file; shows the ranges for this robot")
      .showDefault();
  command.whenChosen([robot] { list(namedMechanism(*robot)); });
  command.footer("Examples:\n  bin/gap effects\n  bin/gap effects --robot so101");
}

}  // namespace plumbline::gap
