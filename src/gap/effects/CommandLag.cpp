#include <cmath>
#include <limits>

#include "gap/effects/Effect.h"

namespace plumbline::gap {

namespace {

/// Replaces commands, which are held from one cycle to the next, by those that the filter turns into them: at
/// the end of each cycle its output is the old command. Within the cycle it is late. Returns the mean of that
/// lateness [s].
double holdBefore(const std::vector<double>& time, double lag, std::vector<double>& commands) {
  const std::vector<double> wanted = commands;
  double last = std::numeric_limits<double>::quiet_NaN(), late = 0, held = 0;
  for (std::size_t k = 0; k + 1 < wanted.size(); ++k) {
    if (!std::isfinite(wanted[k])) continue;
    std::size_t next = k + 1;
    while (next + 1 < wanted.size() && !std::isfinite(wanted[next])) ++next;
    const double h = time[next] - time[k], comes = -std::expm1(-h / lag);
    if (std::isfinite(last)) commands[k] = last + (wanted[k] - last) / comes;
    last = wanted[k];
    late += h * (lag + h - h / comes);
    held += h;
  }
  return held > 0 ? late / held : 0;
}

/// The same for commands that move linearly between cycles.
void leadBefore(const std::vector<double>& time, double lag, std::vector<double>& commands) {
  const std::vector<double> wanted = commands;
  for (std::size_t k = 1; k + 1 < wanted.size(); ++k) {
    const double lead = lag * (wanted[k + 1] - wanted[k - 1]) / (time[k + 1] - time[k - 1]);
    if (std::isfinite(lead)) commands[k] += lead;
  }
}

/// The runs get the commands that the filter turns into the recorded ones, so a model without it is wrong.
void sharpen(const ModelAndRuns& data, const Place& place, double lag) {
  for (Run& run : data.runs) {
    const auto commands = run.channels.find(channelName(ChannelKind::command, place.at));
    if (commands == run.channels.end()) continue;
    if (run.linearCommands) {
      leadBefore(run.t, lag, commands->second);
      continue;
    }
    hastenCommands(run, place.at, holdBefore(run.t, lag, commands->second));
  }
}

}  // namespace

/// The servo follows commands through a filter of first order with this time constant, as firmware that
/// smooths its set point does; transport is command_delay.
const Effect commandLag{
    .id = "command_lag",
    .order = 470,
    .unit = "s",
    .sites = {Site::joint},
    .lower = 0,
    .upper = 0.2,
    .starts = {0.005, 0.02, 0.06},
    .linear = true,
    .ofServo = true,
    .delaysCommands = true,
    .sentence = "The servo of {at} smooths its commands: it follows them through a filter.",
    .exposedBy = "steps and fast moves",
    .apply = [](Plant& plant, const Place& place, double value,
                int) { atJoints(plant, place, [value](JointPlant& joint) { joint.commandLag += value; }); },
    .inWalk = true,
    .alike = {"command_delay", 18},
    .drawing = {.where = DrawRange::Where::joint, .low = 0.02, .high = 0.06},
    .planting = {.rank = 12, .apply = sharpen},
};
MAKE_EFFECT(commandLag);

}  // namespace plumbline::gap
