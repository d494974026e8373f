#include <cmath>
#include <limits>

#include "gap/effects/Effect.h"

namespace plumbline::gap {

namespace {

/// Commands whose filtered ones are those given, held from one cycle to the next: at the end of each cycle
/// the filter is where the command was. Meanwhile it is late; returns by how much in the mean [s].
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

/// The runs say that the joint was sent what its filter made of it the commands recorded.
void sharpen(const ModelAndRuns& data, const Place& place, double lag) {
  for (Run& run : data.runs) {
    const auto commands = run.channels.find(channelName(ChannelKind::command, place.at));
    if (commands == run.channels.end()) continue;
    if (run.linearCommands) {
      leadBefore(run.t, lag, commands->second);
      continue;
    }
    JointTiming timing = run.timingOf(place.at);
    timing.cmdAt -= holdBefore(run.t, lag, commands->second);
    run.timing[place.at] = timing;
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
