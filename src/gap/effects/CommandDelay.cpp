#include "gap/effects/Effect.h"

namespace plumbline::gap {

namespace {

/// The runs say that commands reached the servos earlier than they did.
void hasten(const ModelAndRuns& data, const Place& place, double by) {
  for (Run& run : data.runs) {
    if (place.site == Site::everywhere) {
      if (run.timing.empty()) run.timing["*"] = {};
      for (auto& [joint, timing] : run.timing) timing.cmdAt -= by;
      continue;
    }
    hastenCommands(run, place.at, by);
  }
}

}  // namespace

/// Transport and processing time between sending a command and its coming into force.
const Effect commandDelay{
    .id = "command_delay",
    .order = 10,
    .unit = "s",
    .sites = {Site::everywhere, Site::joint},
    .lower = 0,
    .upper = 0.2,
    .starts = {0.002, 0.01, 0.03},
    .linear = true,
    .delaysCommands = true,
    .sentence = "Commands reach {at} later than the model says.",
    .exposedBy = "fast moves and steps",
    .apply = [](Plant& plant, const Place& place, double value,
                int) { atJoints(plant, place, [value](JointPlant& joint) { joint.commandDelay += value; }); },
    .suspect = 7,
    .alike = {"command_lag", 17},
    .drawing = {.where = DrawRange::Where::jointOrAll, .low = 0.003, .high = 0.02},
    .perJointFit = {.rank = 110},
    .planting = {.rank = 8,
                 .ofAll = true,
                 .possible = [](const Mechanism& robot, const Place&) { return robot.numJoints() == 1; },
                 .apply = hasten},
};
MAKE_EFFECT(commandDelay);

}  // namespace plumbline::gap
