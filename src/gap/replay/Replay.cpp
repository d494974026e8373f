#include "gap/replay/Replay.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

#include "gap/replay/Stepper.h"

namespace plumbline::gap {

namespace {

constexpr double freeSettle = 2;  // [s]: a robot put on its feet rocks longer than a hung one
constexpr double nan = std::numeric_limits<double>::quiet_NaN();

/// Where in the prediction a joint's readings go, and the next cycle that is due.
struct Reading {
  std::size_t signal = 0;
  int node = 0;  ///< of the stepper
  SignalKind kind = SignalKind::position;
  double shift = 0;  ///< when in the cycle [s]
  bool unsignedValue = false;
  std::size_t next = 0;
};

double hermite(double x0, double v0, double x1, double v1, double h, double s) {
  const double a = x0, b = v0 * h, d = x1 - x0;
  const double c2 = 3 * d - 2 * b - v1 * h, c3 = -2 * d + b + v1 * h;
  return a + s * (b + s * (c2 + s * c3));
}

}  // namespace

Prediction replay(const Plant& plant, const Trial& trial, const ReplayOptions& options) {
  Prediction result;
  const std::size_t cycles = trial.cycles();
  result.values.assign(trial.signals.size(), std::vector<double>());
  if (cycles < 2) return result;

  std::vector<int> joints = options.joints;
  if (joints.empty() || trial.freeBase) {
    joints.resize(plant.joints.size());
    std::iota(joints.begin(), joints.end(), 0);
  }
  Stepper stepper(plant, trial, joints, options.lostCycles);
  std::vector<int> nodeOf(plant.joints.size(), -1);
  for (std::size_t i = 0; i < joints.size(); ++i)
    nodeOf[static_cast<std::size_t>(joints[i])] = static_cast<int>(i);

  std::vector<Reading> readings;
  std::vector<std::size_t> body;  // signals of the whole robot, read at the cycle's time
  for (std::size_t s = 0; s < trial.signals.size(); ++s) {
    const Signal& signal = trial.signals[s];
    if (signal.joint >= 0) {
      const std::size_t joint = static_cast<std::size_t>(signal.joint);
      if (nodeOf[joint] < 0) continue;
      double shift = 0;
      if (signal.kind == SignalKind::position) shift = trial.positionAt[joint];
      if (signal.kind == SignalKind::velocity) shift = trial.velocityAt[joint];
      readings.push_back({s, nodeOf[joint], signal.kind, shift, signal.unsignedValue, 0});
    } else {
      body.push_back(s);
    }
    result.values[s].assign(cycles, nan);
  }

  double t = trial.time[0];
  const double longest = stepper.geared() ? options.gearStep : options.step;
  // Readings before the run's first cycle want a past: half a second at most is played before it.
  if (options.settle > 0) {
    const double settle = trial.freeBase ? std::max(options.settle, freeSettle) : options.settle;
    const int steps = static_cast<int>(std::ceil(settle / longest));
    for (int i = steps; i > 0; --i) {
      stepper.step(t - i * longest, t - (i - 1) * longest);
    }
  }
  const auto read = [&](double from, double to) {
    for (Reading& reading : readings) {
      while (reading.next < cycles) {
        const double when = trial.time[reading.next] + reading.shift;
        if (when > to + 1e-12) break;
        double& value = result.values[reading.signal][reading.next++];
        const double h = to - from, s = h > 0 ? std::max(0.0, (when - from) / h) : 1;
        switch (reading.kind) {
          case SignalKind::position:
            value = hermite(stepper.shownBefore(reading.node), stepper.rateBefore(reading.node),
                            stepper.shown(reading.node), stepper.rate(reading.node), h, s);
            break;
          case SignalKind::velocity:
            value = (1 - s) * stepper.rateBefore(reading.node) + s * stepper.rate(reading.node);
            break;
          case SignalKind::torque:
            value = stepper.torque(reading.node);
            break;
          case SignalKind::current:
            value = stepper.current(reading.node);
            break;
          case SignalKind::duty:
            value = stepper.duty(reading.node);
            break;
          default:
            break;
        }
        if (reading.unsignedValue) value = std::abs(value);
      }
    }
  };
  stepper.hold();
  read(t, t);
  const double last = std::accumulate(readings.begin(), readings.end(), 0.0,
                                      [](double most, const Reading& r) { return std::max(most, r.shift); });
  stepper.beginBody();
  for (std::size_t k = 0; k < cycles; ++k) {
    if (!body.empty()) stepper.readBody(k, t, body, result.values);
    const double end = k + 1 < cycles ? trial.time[k + 1] : trial.time[k] + last;
    const int steps = static_cast<int>(std::ceil((end - t) / longest - 1e-9));
    const double start = t;
    for (int i = 1; i <= steps; ++i) {
      const double to = i == steps ? end : start + i * (end - start) / steps;
      stepper.step(t, to);
      read(t, to);
      t = to;
    }
  }
  stepper.endBody(body, result.values);
  result.fell = stepper.fell();
  return result;
}

}  // namespace plumbline::gap
