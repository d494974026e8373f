#include "gap/replay/Segments.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace plumbline::gap {

namespace {

constexpr double segment = 5, leadIn = 1.5;  // [s]

double lengthOf(const Trial& trial) { return trial.time.back() - trial.time.front(); }

std::size_t cycleAt(const Trial& trial, double time) {
  return static_cast<std::size_t>(std::ranges::lower_bound(trial.time, time) - trial.time.begin());
}

/// The cycles [from, to) of the trial, those before `compared` played alone.
Trial cut(const Trial& trial, std::size_t from, std::size_t compared, std::size_t to) {
  const auto keep = [&](std::vector<double>& values) {
    if (values.empty()) return;
    values = {values.begin() + static_cast<std::ptrdiff_t>(from),
              values.begin() + static_cast<std::ptrdiff_t>(to)};
  };
  Trial part = trial;
  keep(part.time);
  for (auto* channels : {&part.command, &part.followed, &part.stiffness, &part.voltage})
    for (std::vector<double>& values : *channels) keep(values);
  for (Signal& signal : part.signals) {
    keep(signal.values);
    std::fill_n(signal.values.begin(), compared - from, std::numeric_limits<double>::quiet_NaN());
  }
  return part;
}

}  // namespace

std::vector<Trial> segmentsOf(Trial trial, double most) {
  std::vector<Trial> segments;
  if (trial.freeBase || trial.cycles() < 2 || lengthOf(trial) <= std::max(most, segment)) {
    segments.push_back(std::move(trial));
    return segments;
  }
  const double begin = trial.time.front(), length = lengthOf(trial);
  // As many as are asked for and do not overlap.
  const auto count =
      static_cast<int>(std::max(1.0, std::min(std::round(most / segment), std::floor(length / segment))));
  for (int i = 0; i < count; ++i) {
    // Each in the middle of its part of the recording.
    const double from = (i + 0.5) * length / count - segment / 2;
    const double lead = std::max(0.0, from - leadIn);
    Trial& part = segments.emplace_back(cut(trial, cycleAt(trial, begin + lead), cycleAt(trial, begin + from),
                                            cycleAt(trial, begin + from + segment)));
    // Repeats of the recording are repeats of each segment, and no segment is one of another.
    const std::string where = " (" + std::to_string(std::lround(from)) + " s)";
    part.name += where;
    part.motion += where;
  }
  return segments;
}

std::vector<std::vector<Trial>> segmentsOf(std::vector<Trial> trials, double most) {
  double all = 0;
  for (const Trial& trial : trials)
    if (!trial.freeBase && trial.cycles() > 1) all += lengthOf(trial);
  std::vector<std::vector<Trial>> segments;
  for (Trial& trial : trials) {
    const bool whole = all <= most || trial.cycles() < 2;
    const double share = whole ? all : most * lengthOf(trial) / all;
    segments.push_back(segmentsOf(std::move(trial), share));
  }
  return segments;
}

}  // namespace plumbline::gap
