#include "gap/run/TableMerge.h"

#include <algorithm>
#include <cmath>
#include <complex>
#include <cstdio>
#include <limits>

#include "gap/run/Channel.h"
#include "gap/run/ColumnStatistics.h"
#include "math/Median.h"

namespace plumbline::gap {
namespace {

constexpr double noValue = std::numeric_limits<double>::quiet_NaN();
/// Length of the mean phasor from which on the readings' times have a constant distance from the rows'.
constexpr double steady = 0.5;
constexpr double shortest = 1e-6;  ///< that times differ by [s]

std::string seconds(double x) {
  char text[40];
  std::snprintf(text, sizeof text, "%.3f", x);
  return text;
}

std::string milliseconds(double x) { return shownNumber(std::round(1e5 * x) / 1e2) + " ms"; }

double farthest(const std::vector<double>& x, double from) {
  double most = 0;
  for (const double v : x) most = std::max(most, std::abs(v - from));
  return most;
}

bool isCommand(ChannelKind kind) {
  return kind == ChannelKind::command || kind == ChannelKind::commandSpeed ||
         kind == ChannelKind::commandTorque || kind == ChannelKind::commandCurrent ||
         kind == ChannelKind::stiffness;
}

bool hasKind(const TimedChannels& recording, ChannelKind kind) {
  return std::ranges::any_of(recording.channels,
                             [&](const auto& entry) { return parseChannel(entry.first)->kind == kind; });
}

/// Index of the time nearest to x, in times that grow.
std::size_t nearest(const std::vector<double>& t, double x) {
  const auto after = static_cast<std::size_t>(std::ranges::lower_bound(t, x) - t.begin());
  if (after == 0) return 0;
  if (after == t.size()) return after - 1;
  return x - t[after - 1] <= t[after] - x ? after - 1 : after;
}

class Merger {
public:
  Merger(const std::vector<TimedChannels>& recordings, const MergeOptions& options)
      : recordings_(recordings), options_(options) {}

  MergedChannels run() {
    chooseRows();
    const TimedChannels& rows = recordings_[result_.rowsFrom];
    result_.t = rows.t;
    result_.channels = rows.channels;
    for (std::size_t i = 0; i < recordings_.size(); ++i) {
      if (i == result_.rowsFrom) continue;
      requireOverlap(recordings_[i], rows);
      addCommands(recordings_[i]);
      addReadings(recordings_[i]);
    }
    if (!result_.timing.empty())  // the others are named too, since an entry is for all or for each
      for (const auto& [name, column] : result_.channels)
        if (const auto channel = parseChannel(name); channel->ofJoint())
          result_.timing.try_emplace(channel->place);
    return std::move(result_);
  }

private:
  void chooseRows() {
    double best = std::numeric_limits<double>::infinity();
    for (const bool positions : {true, false})
      for (std::size_t i = 0; i < recordings_.size() && (positions || !std::isfinite(best)); ++i) {
        if (positions && !hasKind(recordings_[i], ChannelKind::position)) continue;
        if (const double step = medianStep(recordings_[i].t); step < best) {
          best = step;
          result_.rowsFrom = i;
        }
      }
    step_ = medianStep(recordings_[result_.rowsFrom].t);
  }

  static void requireOverlap(const TimedChannels& one, const TimedChannels& rows) {
    if (one.t.front() < rows.t.back() && rows.t.front() < one.t.back()) return;
    throw RunError(one.file + ": its times, " + seconds(one.t.front()) + " to " + seconds(one.t.back()) +
                   " s, do not overlap those of " + rows.file + ", " + seconds(rows.t.front()) + " to " +
                   seconds(rows.t.back()) +
                   " s; correct unit or offset under time in the map (with an offset of " +
                   seconds(rows.t.front() - one.t.front()) + " s both begin together)");
  }

  // ---- commands ----
  void addCommands(const TimedChannels& one) {
    std::vector<std::string> names;
    for (const auto& [name, column] : one.channels)
      if (isCommand(parseChannel(name)->kind)) names.push_back(name);
    if (names.empty()) return;
    for (const std::string& name : names) {
      const bool interpolated = options_.linearCommands && parseChannel(name)->kind != ChannelKind::stiffness;
      result_.channels[name] =
          interpolated ? between(one, one.channels.at(name)) : inForce(one, one.channels.at(name));
    }
    sayCommands(one, names);
  }

  std::vector<double> inForce(const TimedChannels& one, const std::vector<double>& column) const {
    std::vector<double> values;
    double last = noValue;
    std::size_t next = 0;
    for (const double t : result_.t) {
      for (; next < one.t.size() && one.t[next] <= t; ++next)
        if (!std::isnan(column[next])) last = column[next];
      values.push_back(last);
    }
    return values;
  }

  std::vector<double> between(const TimedChannels& one, const std::vector<double>& column) const {
    std::vector<std::size_t> known;
    for (std::size_t k = 0; k < column.size(); ++k)
      if (!std::isnan(column[k])) known.push_back(k);
    std::vector<double> values;
    std::size_t next = 0;  // of known: the first behind the row
    for (const double t : result_.t) {
      while (next < known.size() && one.t[known[next]] <= t) ++next;
      const bool before = next > 0;
      if (before && one.t[known[next - 1]] == t) {
        values.push_back(column[known[next - 1]]);
      } else if (before && next < known.size()) {
        const std::size_t a = known[next - 1], b = known[next];
        const double share = (t - one.t[a]) / (one.t[b] - one.t[a]);
        values.push_back(column[a] + share * (column[b] - column[a]));
      } else {
        values.push_back(noValue);
      }
    }
    return values;
  }

  void sayCommands(const TimedChannels& one, const std::vector<std::string>& names) {
    std::vector<double> late;  // of the rows at which a command is new: its time less the row's
    std::size_t before = 0, next = 0, replaced = 0;
    for (const double t : result_.t) {
      const std::size_t old = next;
      while (next < one.t.size() && one.t[next] <= t) ++next;
      before += next == 0;
      if (next == old) continue;
      late.push_back(one.t[next - 1] - t);
      replaced += next - old - 1;
    }
    std::string said = one.file + ": " + std::to_string(one.t.size()) + " lines of commands onto " +
                       std::to_string(result_.t.size()) + " rows";
    if (options_.linearCommands) {
      said += ", interpolated";
    } else if (replaced > 0) {
      said += "; replaced before the next row: " + std::to_string(replaced);
      if (5 * replaced > one.t.size()) said += " (hold: linear interpolates)";
    }
    if (before > 0) said += "; rows before the first: " + std::to_string(before) + ", without a command";
    if (next < one.t.size()) said += "; behind the last row: " + std::to_string(one.t.size() - next);
    if (const double gone = result_.t.back() - one.t.back(); gone > 1 && !options_.linearCommands)
      said += "; the last is held for " + seconds(gone) + " s";
    const double shift = upperMedian(late), most = farthest(late, shift);
    if (!options_.linearCommands && !options_.timingStated && std::abs(shift) > shortest) {
      for (const std::string& name : names)
        if (const ChannelName channel = *parseChannel(name); channel.kind != ChannelKind::stiffness)
          result_.timing[channel.place].cmdAt = shift;
      said += "; sent " + milliseconds(-shift) + " before their row (cmd_at_s in timing)";
      if (most > shortest) said += ", +-" + milliseconds(most);
    }
    result_.notes.push_back(said);
  }

  // ---- readings ----
  void addReadings(const TimedChannels& one) {
    std::vector<std::string> names;
    for (const auto& [name, column] : one.channels)
      if (!isCommand(parseChannel(name)->kind)) names.push_back(name);
    if (names.empty()) return;
    const double shift = options_.timingStated ? 0 : phaseOf(one), limit = one.within.value_or(step_ / 2);
    std::vector<std::size_t> partner(result_.t.size(), one.t.size());
    for (std::size_t k = 0; k < one.t.size(); ++k) {
      const double t = one.t[k] - shift;
      const std::size_t row = nearest(result_.t, t);
      if (std::abs(t - result_.t[row]) > limit * (1 + 1e-9)) continue;
      std::size_t& now = partner[row];
      if (now == one.t.size() || std::abs(t - result_.t[row]) < std::abs(one.t[now] - shift - result_.t[row]))
        now = k;
    }
    std::vector<double> apart;
    for (std::size_t row = 0; row < partner.size(); ++row)
      if (partner[row] < one.t.size()) apart.push_back(one.t[partner[row]] - result_.t[row]);
    if (apart.empty())
      throw RunError(one.file + ": no reading is within " + milliseconds(limit) + " of a row of " +
                     recordings_[result_.rowsFrom].file + "; correct offset or within under time in the map");
    for (const std::string& name : names) {
      const std::vector<double>& column = one.channels.at(name);
      std::vector<double>& values = result_.channels[name];
      for (const std::size_t k : partner) values.push_back(k < one.t.size() ? column[k] : noValue);
    }
    const double constant = shift != 0 ? upperMedian(apart) : 0;
    if (constant != 0)
      for (const std::string& name : names) {
        const ChannelName channel = *parseChannel(name);
        if (channel.kind == ChannelKind::position) result_.timing[channel.place].posAt = constant;
        if (channel.kind == ChannelKind::torque || channel.kind == ChannelKind::current ||
            channel.kind == ChannelKind::duty)
          result_.timing[channel.place].effortAt = constant;
        if (channel.kind == ChannelKind::velocity) result_.timing[channel.place].velAt = constant;
      }
    std::string said =
        one.file + ": " + std::to_string(apart.size()) + " of " + std::to_string(one.t.size()) +
        " readings stand in a row; rows without one: " + std::to_string(result_.t.size() - apart.size());
    if (constant != 0) said += "; taken " + milliseconds(constant) + " from their row (pos_at_s in timing)";
    if (const double most = farthest(apart, constant); most > shortest)
      said += std::string(constant != 0 ? ", +-" : "; taken up to ") + milliseconds(most) +
              (constant != 0 ? "" : " from their row");
    result_.notes.push_back(said);
  }

  /// Constant distance of the readings' times from the rows', within half a row; 0 where there is none.
  double phaseOf(const TimedChannels& one) const {
    std::complex<double> sum = 0;
    double count = 0;
    for (const double t : one.t) {
      if (t < result_.t.front() - step_ || t > result_.t.back() + step_) continue;
      sum += std::polar(1.0, 2 * M_PI * (t - result_.t[nearest(result_.t, t)]) / step_);
      ++count;
    }
    if (count == 0 || std::abs(sum) < steady * count) return 0;
    const double shift = step_ * std::arg(sum) / (2 * M_PI);
    return std::abs(shift) > shortest ? shift : 0;
  }

  const std::vector<TimedChannels>& recordings_;
  const MergeOptions options_;
  double step_ = 0;  ///< of the rows [s]
  MergedChannels result_;
};

}  // namespace

MergedChannels mergeChannels(const std::vector<TimedChannels>& recordings, const MergeOptions& options) {
  return Merger(recordings, options).run();
}

}  // namespace plumbline::gap
