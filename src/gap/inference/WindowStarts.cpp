#include "gap/inference/WindowStarts.h"

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>
#include <limits>

#include "gap/inference/Groups.h"

namespace plumbline::gap {

namespace {

constexpr double secondsAroundStart = 0.03;  // [s] to either side of a start that determine its state
constexpr std::size_t leastReadings = 3;     // to either side
constexpr std::size_t leastCycles = 12;      // of a window

MeasuredState unknownState() {
  constexpr double nan = std::numeric_limits<double>::quiet_NaN();
  return {nan, nan, Eigen::Matrix2d::Zero()};
}

/// A polynomial fitted to values by least squares.
struct Polynomial {
  Eigen::VectorXd x;        ///< coefficients, the constant first
  Eigen::MatrixXd inverse;  ///< of the normal equations: their covariance at unit variance
  double variance = 0;      ///< of what is left
};

Polynomial polynomialThrough(const std::vector<double>& times, const std::vector<double>& values,
                             int degree) {
  const auto n = static_cast<Eigen::Index>(times.size());
  const Eigen::Map<const Eigen::VectorXd> t(times.data(), n), y(values.data(), n);
  // In units of the farthest time, so that powers are alike.
  const double unit = t.cwiseAbs().maxCoeff();
  Eigen::MatrixXd design = Eigen::MatrixXd::Ones(n, degree + 1);
  for (Eigen::Index i = 1; i <= degree; ++i) design.col(i) = design.col(i - 1).cwiseProduct(t / unit);
  const Eigen::LDLT<Eigen::MatrixXd> solver(design.transpose() * design);
  Eigen::VectorXd units(degree + 1);
  for (Eigen::Index i = 0; i <= degree; ++i) units[i] = std::pow(unit, -static_cast<double>(i));
  const Eigen::VectorXd x = solver.solve(design.transpose() * y);
  const double left =
      (y - design * x).squaredNorm() / static_cast<double>(std::max<Eigen::Index>(1, n - degree - 1));
  const Eigen::MatrixXd inverse = solver.solve(Eigen::MatrixXd::Identity(degree + 1, degree + 1));
  return {units.cwiseProduct(x), units.asDiagonal() * inverse * units.asDiagonal(), left};
}

}  // namespace

MeasuredState stateAt(const Trial& trial, const Signal& signal, std::size_t cycle, double noise) {
  const double cycleSeconds =
      (trial.time.back() - trial.time.front()) / static_cast<double>(trial.cycles() - 1);
  const auto each = std::max(leastReadings, static_cast<std::size_t>(secondsAroundStart / cycleSeconds));
  const std::size_t from = cycle > each ? cycle - each : 0, to = std::min(trial.cycles(), cycle + each + 1);
  const double shift = trial.positionAt[static_cast<std::size_t>(signal.joint)];
  std::vector<double> times, values;
  for (std::size_t k = from; k < to; ++k) {
    if (!std::isfinite(signal.values[k])) continue;
    times.push_back(trial.time[k] + shift - trial.time[cycle]);
    values.push_back(signal.values[k]);
  }
  if (times.size() < 2 * leastReadings) return unknownState();
  const Polynomial square = polynomialThrough(times, values, 2), cubic = polynomialThrough(times, values, 3);
  if (!square.x.allFinite() || !cubic.x.allFinite()) return unknownState();
  const Eigen::Vector2d bend = cubic.x.head<2>() - square.x.head<2>();
  return {square.x[0], square.x[1],
          std::max(noise * noise, square.variance) * square.inverse.topLeftCorner<2, 2>() +
              bend * bend.transpose()};
}

namespace {

/// Of all joints at a cycle; NaN where a position is not measured.
std::vector<MeasuredState> statesAt(const Trial& trial, std::size_t cycle,
                                    const std::vector<double>& noises) {
  std::vector<MeasuredState> states(trial.robot->joints.size(), unknownState());
  for (std::size_t s = 0; s < trial.signals.size(); ++s)
    if (trial.signals[s].kind == SignalKind::position)
      states[static_cast<std::size_t>(trial.signals[s].joint)] =
          stateAt(trial, trial.signals[s], cycle, noises[s]);
  return states;
}

/// Sum of the variances of the speeds that are known; infinite if none is.
double doubtOf(const std::vector<MeasuredState>& states) {
  double sum = 0;
  bool any = false;
  for (const MeasuredState& state : states)
    if (std::isfinite(state.speed)) sum += state.covariance(1, 1), any = true;
  return any ? sum : std::numeric_limits<double>::infinity();
}

}  // namespace

std::vector<Window> windowsIn(const Trial& trial, double seconds, const std::vector<double>& noises) {
  std::vector<Window> windows;
  const auto endOf = [&](std::size_t from) {
    const auto to = static_cast<std::size_t>(
        std::ranges::lower_bound(trial.time, trial.time[from] + seconds) - trial.time.begin());
    return std::max(to, from + leastCycles);
  };
  for (std::size_t next = firstScored(trial); next < trial.cycles() && endOf(next) <= trial.cycles();) {
    Window window{next, 0, statesAt(trial, next, noises)};
    const std::size_t last = next + (endOf(next) - next) / 2;
    for (std::size_t from = next + 1; from <= last && endOf(from) <= trial.cycles(); ++from) {
      std::vector<MeasuredState> starts = statesAt(trial, from, noises);
      if (doubtOf(starts) < doubtOf(window.starts)) window.from = from, window.starts = std::move(starts);
    }
    window.to = endOf(window.from);
    if (trial.time[window.from] + seconds > trial.time.back() + 1e-9) break;
    next = window.to;
    windows.push_back(std::move(window));
  }
  return windows;
}

Trial restartedAt(const std::vector<Window>& windows, Trial trial, const StartShift& shift) {
  trial.restarts.clear();
  for (const Window& window : windows) {
    Restart restart{window.from, {}, {}, {}};
    for (const MeasuredState& start : window.starts) {
      restart.position.push_back(start.position + shift.position);
      restart.speed.push_back(start.speed + shift.speed);
    }
    trial.restarts.push_back(std::move(restart));
  }
  return trial;
}

}  // namespace plumbline::gap
