#include "gap/diagnosis/SensorChange.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace plumbline::gap {

namespace {

/// Value of a series at a time, linear between its samples.
double valueAt(const std::vector<double>& time, const std::vector<double>& values, double when) {
  const auto next = std::ranges::upper_bound(time, when);
  if (next == time.begin()) return values.front();
  if (next == time.end()) return values.back();
  const auto i = static_cast<std::size_t>(next - time.begin());
  const double share = (when - time[i - 1]) / (time[i] - time[i - 1]);
  return values[i - 1] + share * (values[i] - values[i - 1]);
}

}  // namespace

Prediction sensorChange(const Plant& before, const Plant& after, const Trial& trial,
                        const Prediction& predicted) {
  Prediction result;
  result.values.resize(trial.signals.size());
  for (const SignalKind kind : {SignalKind::gyro, SignalKind::accelerometer}) {
    std::array<int, 3> axes{-1, -1, -1};
    for (std::size_t s = 0; s < trial.signals.size(); ++s)
      if (trial.signals[s].kind == kind)
        axes[static_cast<std::size_t>(trial.signals[s].axis)] = static_cast<int>(s);
    if (axes[0] < 0 || axes[1] < 0 || axes[2] < 0) continue;
    const auto series = [&](std::size_t axis) -> const std::vector<double>& {
      return predicted.values[static_cast<std::size_t>(axes[axis])];
    };
    if (series(0).empty()) continue;
    const Vec3 biasBefore = kind == SignalKind::gyro ? before.imu.gyroBias : Vec3::Zero();
    const Vec3 biasAfter = kind == SignalKind::gyro ? after.imu.gyroBias : Vec3::Zero();
    const Mat3 turn = after.imu.R_true_sensor.transpose() * before.imu.R_true_sensor;
    const double later = after.imu.delay - before.imu.delay;
    for (std::size_t a = 0; a < 3; ++a)
      result.values[static_cast<std::size_t>(axes[a])].resize(trial.cycles());
    for (std::size_t k = 0; k < trial.cycles(); ++k) {
      Vec3 shown;
      for (std::size_t a = 0; a < 3; ++a) {
        shown[static_cast<Eigen::Index>(a)] =
            later == 0 ? series(a)[k] : valueAt(trial.time, series(a), trial.time[k] - later);
      }
      const Vec3 now = turn * (shown - biasBefore) + biasAfter;
      for (std::size_t a = 0; a < 3; ++a)
        result.values[static_cast<std::size_t>(axes[a])][k] = now[static_cast<Eigen::Index>(a)];
    }
  }
  for (std::size_t s = 0; s < trial.signals.size(); ++s) {
    const Signal& signal = trial.signals[s];
    if (signal.kind != SignalKind::force || predicted.values[s].empty()) continue;
    const auto foot = static_cast<std::size_t>(signal.place);
    const double factor = after.footGain[foot] / before.footGain[foot];
    result.values[s] = predicted.values[s];
    for (double& value : result.values[s]) value *= factor;
  }
  return result;
}

}  // namespace plumbline::gap
