#include "gap/settings/TraceEvidence.h"

#include <algorithm>
#include <cmath>
#include <set>

#include "framework/ConfigurationError.h"
#include "framework/Parallel.h"

namespace plumbline::gap {

namespace {

using simspark::LeagueTrace;
using simspark::TraceRow;

/// Half the last digit that recordings have (tests/data/traces/README.md).
constexpr WindowError halfDigit = {5e-7, 5e-7, 0.005 * M_PI / 180, 0.005 * M_PI / 180, 0.005, 0.005};
constexpr double idleWay = 5e-4, idleTurn = 0.003;  // [m, rad] in a window

double verticalForce(const TraceRow& row, bool left) {
  double sum = 0;
  for (const auto* reading :
       {left ? &row.leftFootForce : &row.rightFootForce, left ? &row.leftToeForce : &row.rightToeForce})
    if (*reading) sum += ((left ? row.leftFoot : row.rightFoot).linear() * (*reading)->force).z();
  return sum;
}

/// Squares of all components of a signal's difference, and how many they are.
std::pair<double, double> squares(TraceSignal signal, const LeagueTrace& trace, const TraceRow& a,
                                  const TraceRow& b) {
  switch (signal) {
    case TraceSignal::torsoPosition:
      return {(a.torso.translation() - b.torso.translation()).squaredNorm(), 3};
    case TraceSignal::torsoRotation: {
      const double angle = Eigen::AngleAxisd(a.torso.linear().transpose() * b.torso.linear()).angle();
      return {angle * angle, 3};
    }
    case TraceSignal::joints: {
      double sum = 0;
      for (const JointId joint : trace.joints)
        sum += (a.angle[joint] - b.angle[joint]) * (a.angle[joint] - b.angle[joint]);
      return {sum, static_cast<double>(trace.joints.size())};
    }
    case TraceSignal::gyro:
      return {(a.gyro - b.gyro).squaredNorm(), 3};
    case TraceSignal::accelerometer:
      return {(a.acc - b.acc).squaredNorm(), 3};
    case TraceSignal::footForce: {
      const double l = verticalForce(a, true) - verticalForce(b, true),
                   r = verticalForce(a, false) - verticalForce(b, false);
      return {l * l + r * r, 2};
    }
  }
  return {0, 1};
}

WindowError errorBetween(const LeagueTrace& trace, std::size_t first, const std::vector<TraceRow>& played) {
  WindowError error{};
  for (std::size_t s = 0; s < numTraceSignals; ++s) {
    const auto signal = static_cast<TraceSignal>(s);
    double sum = 0, n = 0;
    // The accelerometer shows the step before, which a replay knows from its second row on.
    for (std::size_t i = signal == TraceSignal::accelerometer ? 1 : 0; i < played.size(); ++i) {
      const auto [square, count] = squares(signal, trace, trace.rows[first + 1 + i], played[i]);
      sum += square;
      n += count;
    }
    error[s] = n > 0 ? sum / n : 0;
  }
  return error;
}

bool moves(const LeagueTrace& trace, std::size_t first, std::size_t rows) {
  const TraceRow& start = trace.rows[first];
  double way = 0, turn = 0;
  for (std::size_t i = first + 1; i <= first + rows; ++i) {
    way = std::max(way, (trace.rows[i].torso.translation() - start.torso.translation()).norm());
    for (const JointId joint : trace.joints)
      turn = std::max(turn, std::abs(trace.rows[i].angle[joint] - start.angle[joint]));
  }
  return way > idleWay || turn > idleTurn;
}

double rounded(double value, double digit) { return std::round(value / digit) * digit; }

Vec3 rounded(const Vec3& v, double digit) {
  return v.unaryExpr([digit](double x) { return rounded(x, digit); });
}

/// As a recording would have it.
TraceRow asRecorded(TraceRow row) {
  constexpr double degree = M_PI / 180;
  for (double& angle : row.angle) angle = rounded(angle, 0.01 * degree);
  for (double& angle : row.axisAngle) angle = rounded(angle, 1e-4 * degree);
  row.gyro = rounded(row.gyro, 0.01 * degree);
  row.acc = rounded(row.acc, 0.01);
  row.torso.translation() = rounded(row.torso.translation(), 1e-6);
  return row;
}

}  // namespace

const char* nameOf(TraceSignal signal) {
  constexpr const char* names[] = {"torso position", "torso rotation", "joints",
                                   "gyro",           "accelerometer",  "foot force"};
  return names[static_cast<std::size_t>(signal)];
}

const char* unitOf(TraceSignal signal) {
  constexpr const char* units[] = {"m", "rad", "rad", "rad/s", "m/s^2", "N"};
  return units[static_cast<std::size_t>(signal)];
}

TraceEvidence::TraceEvidence(std::vector<LeagueTrace> traces, std::size_t rows, std::size_t every)
    : recordings_(std::move(traces)) {
  std::set<int> types;
  for (const LeagueTrace& trace : recordings_) types.insert(trace.robotType.value_or(0));
  for (std::size_t t = 0; t < recordings_.size(); ++t) {
    const auto rank = types.size() > 1
                          ? std::distance(types.begin(), types.find(recordings_[t].robotType.value_or(0)))
                          : static_cast<std::ptrdiff_t>(t);
    leftOut_.push_back(rank % 2 == 1);
    for (std::size_t first = firstRow; first + rows < recordings_[t].rows.size(); first += every)
      if (moves(recordings_[t], first, rows)) cut_.push_back({t, first, rows, leftOut_.back()});
  }
  const auto countLeftOut = std::ranges::count(cut_, true, &TraceWindow::leftOut);
  if (countLeftOut < 5 || static_cast<std::size_t>(countLeftOut) + 5 > cut_.size())
    throw ConfigurationError(
        "too few recordings in which the robot moves: some are for fitting and some of "
        "another robot type for judging; give at least two");
}

WindowError TraceEvidence::errorOf(const TraceWindow& window, const SimulatorSetup& setup) const {
  const LeagueTrace& trace = recordings_[window.trace];
  return errorBetween(trace, window.first, play(trace, window.first, window.rows, setup));
}

std::vector<WindowError> TraceEvidence::ownErrors(const SimulatorSetup& setup, int jobs) const {
  std::vector<LeagueTrace> own(recordings_.size());
  parallel(recordings_.size(), jobs, [&](std::size_t t) {
    const LeagueTrace& trace = recordings_[t];
    own[t] = trace;
    own[t].rows.assign(trace.rows.begin(), trace.rows.begin() + firstRow + 1);
    for (TraceRow& row : play(trace, firstRow, trace.rows.size(), setup))
      own[t].rows.push_back(asRecorded(std::move(row)));
  });
  std::vector<WindowError> errors(cut_.size());
  parallel(cut_.size(), jobs, [&](std::size_t w) {
    const TraceWindow& window = cut_[w];
    errors[w] = errorBetween(own[window.trace], window.first,
                             play(own[window.trace], window.first, window.rows, setup));
  });
  return errors;
}

WindowError typicalError(const std::vector<WindowError>& errors) {
  WindowError typical{};
  for (std::size_t s = 0; s < numTraceSignals; ++s) {
    std::vector<double> sizes;
    sizes.reserve(errors.size());
    for (const WindowError& error : errors) sizes.push_back(std::isfinite(error[s]) ? error[s] : 1e12);
    std::ranges::sort(sizes);
    sizes.resize((sizes.size() * 9 + 9) / 10);
    double sum = 0;
    for (const double size : sizes) sum += size;
    typical[s] =
        std::max(halfDigit[s], std::sqrt(sum / std::max<double>(1, static_cast<double>(sizes.size()))));
  }
  return typical;
}

std::vector<LeagueTrace> readTraces(const std::filesystem::path& folder) {
  std::error_code error;
  std::vector<std::filesystem::path> files;
  for (const auto& entry : std::filesystem::directory_iterator(folder, error))
    if (entry.path().string().ends_with(".csv.gz")) files.push_back(entry.path());
  if (error) throw ConfigurationError(folder.string() + ": no folder of recordings can be read here");
  std::ranges::sort(files);
  std::vector<LeagueTrace> traces;
  for (const auto& file : files) {
    if (file.filename().string().starts_with("ball")) continue;
    LeagueTrace trace = simspark::readLeagueTrace(file);
    const bool alone = !trace.robot;
    if (alone && trace.robotType && trace.rows.size() > firstRow + 1) traces.push_back(std::move(trace));
  }
  if (traces.empty())
    throw ConfigurationError(folder.string() +
                             ": no recordings of a robot, *_t0.csv.gz to *_t4.csv.gz, are in this folder");
  return traces;
}

}  // namespace plumbline::gap
