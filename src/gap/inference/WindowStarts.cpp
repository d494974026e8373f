#include "gap/inference/WindowStarts.h"

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>
#include <limits>

#include "gap/inference/Groups.h"

namespace plumbline::gap {

namespace {

constexpr double besideStart = 0.03;     // [s] to either side of a start that tell its state
constexpr std::size_t leastBeside = 3;   // readings to either side
constexpr std::size_t leastCycles = 12;  // of a window

MeasuredState unknownState() {
  constexpr double nan = std::numeric_limits<double>::quiet_NaN();
  return {nan, nan, Eigen::Matrix2d::Zero()};
}

}  // namespace

MeasuredState stateAt(const Trial& trial, const Signal& signal, std::size_t cycle, double noise) {
  const double cycleSeconds =
      (trial.time.back() - trial.time.front()) / static_cast<double>(trial.cycles() - 1);
  const auto each = std::max(leastBeside, static_cast<std::size_t>(besideStart / cycleSeconds));
  const std::size_t from = cycle > each ? cycle - each : 0, to = std::min(trial.cycles(), cycle + each + 1);
  const double shift = trial.positionAt[static_cast<std::size_t>(signal.joint)];
  Eigen::Matrix3d normal = Eigen::Matrix3d::Zero();
  Eigen::Vector3d right = Eigen::Vector3d::Zero();
  double squares = 0;
  std::size_t count = 0;
  for (std::size_t k = from; k < to; ++k) {
    if (!std::isfinite(signal.values[k])) continue;
    const double t = trial.time[k] + shift - trial.time[cycle];
    const Eigen::Vector3d row(1, t, t * t);
    normal += row * row.transpose();
    right += signal.values[k] * row;
    squares += signal.values[k] * signal.values[k];
    ++count;
  }
  if (count < 2 * leastBeside) return unknownState();
  const Eigen::LDLT<Eigen::Matrix3d> solver(normal);
  const Eigen::Vector3d x = solver.solve(right);
  if (!x.allFinite()) return unknownState();
  const double left = std::max(0.0, squares - right.dot(x)) / static_cast<double>(count - 3);
  const Eigen::Matrix3d inverse = solver.solve(Eigen::Matrix3d::Identity());
  return {x[0], x[1], std::max(noise * noise, left) * inverse.topLeftCorner<2, 2>()};
}

std::vector<Window> windowsIn(const Trial& trial, double seconds, const std::vector<double>& noises) {
  std::vector<Window> windows;
  const double end = trial.time.back();
  for (std::size_t from = firstScored(trial); from < trial.cycles();) {
    auto to = static_cast<std::size_t>(std::ranges::lower_bound(trial.time, trial.time[from] + seconds) -
                                       trial.time.begin());
    to = std::max(to, from + leastCycles);
    if (to > trial.cycles() || trial.time[from] + seconds > end + 1e-9) break;
    Window window{from, to, std::vector<MeasuredState>(trial.robot->joints.size(), unknownState())};
    for (std::size_t s = 0; s < trial.signals.size(); ++s)
      if (trial.signals[s].kind == SignalKind::position)
        window.starts[static_cast<std::size_t>(trial.signals[s].joint)] =
            stateAt(trial, trial.signals[s], from, noises[s]);
    windows.push_back(std::move(window));
    from = to;
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
