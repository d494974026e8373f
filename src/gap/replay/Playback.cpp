#include "gap/replay/Playback.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

#include "framework/StopSignal.h"

namespace plumbline::gap {

namespace {

constexpr double freeSettle = 2;  // [s]: a robot put on its feet rocks longer than a hung one

double hermite(double x0, double v0, double x1, double v1, double h, double s) {
  const double a = x0, b = v0 * h, d = x1 - x0;
  const double c2 = 3 * d - 2 * b - v1 * h, c3 = -2 * d + b + v1 * h;
  return a + s * (b + s * (c2 + s * c3));
}

double settlingTime(const Trial& trial, const ReplayOptions& options) {
  // Put into a measured state at once.
  if (options.restarts && !trial.restarts.empty()) return 0;
  return options.settle > 0 && trial.freeBase ? std::max(options.settle, freeSettle) : options.settle;
}

/// Whether nothing of the whole body is read, or put into the state, at the begin of a cycle.
bool mayCross(const Trial& trial, const ReplayOptions& options) {
  return !trial.freeBase && !(options.restarts && !trial.restarts.empty()) &&
         std::ranges::none_of(trial.signals, [](const Signal& signal) { return signal.joint < 0; });
}

/// Whether some joints are played that all others act on: through a supply that sags under all motors.
bool needsOthers(const Plant& plant, const Trial& trial, const ReplayOptions& options) {
  return !options.joints.empty() && !trial.freeBase && SupplyRail(plant.joints).hasVoltageDrop();
}

std::vector<int> jointsToPlay(const Plant& plant, const Trial& trial, const ReplayOptions& options) {
  if (!options.joints.empty() && !trial.freeBase && !needsOthers(plant, trial, options))
    return options.joints;
  std::vector<int> all(plant.joints.size());
  std::iota(all.begin(), all.end(), 0);
  return all;
}

/// Whether a joint's readings are wanted of a replay, which may have to move more.
bool asked(int joint, const Trial& trial, const ReplayOptions& options) {
  return options.joints.empty() || trial.freeBase ||
         std::ranges::find(options.joints, joint) != options.joints.end();
}

/// Which cycles' commands are known to be lost; null: that is unknown.
const std::vector<std::uint8_t>* lostIn(const Trial& trial, const ReplayOptions& options) {
  if (options.lostCycles) return options.lostCycles;
  return options.asSent || trial.lost.empty() ? nullptr : &trial.lost;
}

/// Joints that are played for their load alone are the nominal ones, so that a replay of some joints depends
/// on nothing but what is at them. The plant itself where there are none such.
std::shared_ptr<const Plant> plantToPlay(const Plant& plant, const Trial& trial,
                                         const ReplayOptions& options) {
  if (!needsOthers(plant, trial, options)) return {std::shared_ptr<const Plant>(), &plant};
  auto result = std::make_shared<Plant>(plant);
  for (std::size_t j = 0; j < plant.joints.size(); ++j) {
    if (asked(static_cast<int>(j), trial, options)) continue;
    const Mechanism::Joint& joint = trial.robot->joints[j];
    result->joints[j] = JointPlant::nominal(joint);
    result->joints[j].supplySag = plant.joints[j].supplySag;
    const auto link = static_cast<std::size_t>(joint.child);
    result->mechanism.links[link] = trial.robot->links[link];
    result->mechanism.joints[j] = joint;
  }
  return result;
}

}  // namespace

Playback::Playback(const Plant& plant, const Trial& trial, const ReplayOptions& options)
    : trial_(trial),
      plant_(plantToPlay(plant, trial, options)),
      stepper_(*plant_, trial, jointsToPlay(plant, trial, options), lostIn(trial, options)),
      longest_(stepper_.geared() ? options.gearStep : options.step),
      settleFor_(settlingTime(trial, options)),
      t_(trial.time[0]),
      mayCross_(mayCross(trial, options)),
      acrossCycles_(options.acrossCycles && mayCross_) {
  const std::vector<int> joints = jointsToPlay(plant, trial_, options);
  for (std::size_t s = 0; s < trial_.signals.size(); ++s) {
    const Signal& signal = trial_.signals[s];
    const auto place = std::ranges::find(joints, signal.joint);
    if (signal.joint < 0 || place == joints.end() || !asked(signal.joint, trial_, options)) continue;
    const auto joint = static_cast<std::size_t>(signal.joint);
    double shift = 0;
    if (signal.kind == SignalKind::position) shift = trial_.positionAt[joint];
    if (signal.kind == SignalKind::velocity) shift = trial_.velocityAt[joint];
    if (isEffort(signal.kind) && joint < trial_.effortAt.size()) shift = trial_.effortAt[joint];
    readings_.push_back({s, static_cast<int>(place - joints.begin()), signal.kind, shift,
                         signal.unsignedValue, signal.ofSupply});
    if (isEffort(signal.kind)) {
      readings_.back().seen = positionOf(trial_, signal.joint);
      readsEfforts_ = true;
    }
    lastShift_ = std::max(lastShift_, shift);
  }
}

bool Playback::reads(std::size_t signal) const {
  return std::ranges::any_of(readings_, [&](const Reading& reading) { return reading.signal == signal; });
}

const std::vector<Playback::Shown>& Playback::settle() {
  due_.clear();
  if (settleFor_ > 0) {
    const int steps = static_cast<int>(std::ceil(settleFor_ / longest_));
    for (int i = steps; i > 0; --i) {
      StopSignal::throwIfCaught();
      stepper_.step(t_ - i * longest_, t_ - (i - 1) * longest_);
    }
  }
  stepper_.hold();
  read(t_, t_);
  return due_;
}

std::size_t Playback::lastInStep(std::size_t cycle) const {
  std::size_t last = cycle;
  if (readsEfforts_ || !mayCross_) return last;
  while (last + 2 < trial_.cycles() && (trial_.time[last + 2] - trial_.time[cycle]) / longest_ - 1e-9 <= 1)
    ++last;
  return last;
}

const std::vector<Playback::Shown>& Playback::playTo(std::size_t cycle) {
  due_.clear();
  const double end = cycle + 1 < trial_.cycles() ? trial_.time[cycle + 1] : trial_.time[cycle] + lastShift_;
  if (acrossCycles_ && !readsEfforts_) {
    const double last = trial_.time.back() + lastShift_;
    while (t_ < end - longest_ * 1e-9) {
      StopSignal::throwIfCaught();
      const double to = std::min(t_ + longest_, last);
      stepper_.step(t_, to);
      read(t_, to);
      t_ = to;
    }
    return due_;
  }
  const int steps = static_cast<int>(std::ceil((end - t_) / longest_ - 1e-9));
  const double start = t_;
  for (int i = 1; i <= steps; ++i) {
    StopSignal::throwIfCaught();
    const double to = i == steps ? end : start + i * (end - start) / steps;
    stepper_.step(t_, to);
    read(t_, to);
    t_ = to;
  }
  return due_;
}

void Playback::read(double from, double to) {
  const double h = to - from, until = to + 1e-12;
  if (nextRead_ > until) return;
  nextRead_ = std::numeric_limits<double>::infinity();
  for (Reading& reading : readings_)
    while (reading.next < trial_.cycles()) {
      const double when = trial_.time[reading.next] + reading.shift;
      if (when > until) {
        nextRead_ = std::min(nextRead_, when);
        break;
      }
      const double value = valueOf(reading, h, h > 0 ? std::max(0.0, (when - from) / h) : 1);
      due_.push_back({reading.signal, reading.next++, reading.unsignedValue ? std::abs(value) : value});
    }
}

double Playback::valueOf(const Reading& reading, double h, double s) const {
  switch (reading.kind) {
    case SignalKind::position:
      return hermite(stepper_.shownBefore(reading.node), stepper_.rateBefore(reading.node),
                     stepper_.shown(reading.node), stepper_.rate(reading.node), h, s);
    case SignalKind::velocity:
      return (1 - s) * stepper_.rateBefore(reading.node) + s * stepper_.rate(reading.node);
    case SignalKind::torque:
      return torqueIn(reading, seenAt(reading));
    case SignalKind::current:
      return currentIn(reading);
    case SignalKind::duty:
      return dutyIn(reading);
    default:
      return std::numeric_limits<double>::quiet_NaN();
  }
}

Playback::Seen Playback::seenAt(const Reading& reading) const {
  if (!reading.seen) return {stepper_.shown(reading.node), stepper_.rate(reading.node)};
  // Positions are read a moment before or after the efforts.
  const std::size_t k = reading.next;
  const auto joint = static_cast<std::size_t>(trial_.signals[reading.signal].joint);
  const std::vector<double>& angle = reading.seen->values;
  const double late = trial_.positionAt[joint] - reading.shift;
  const std::size_t other = late > 0 ? (k > 0 ? k - 1 : k) : std::min(k + 1, trial_.cycles() - 1);
  Seen seen{angle[k], rateAt(trial_, *reading.seen, k)};
  if (other != k)
    seen.shown +=
        std::min(1.0, std::abs(late / (trial_.time[k] - trial_.time[other]))) * (angle[other] - angle[k]);
  return seen;
}

double Playback::dutyIn(const Reading& reading) const {
  const std::size_t k = reading.next;
  const auto joint = static_cast<std::size_t>(trial_.signals[reading.signal].joint);
  if (joint < trial_.stiffness.size() && !trial_.stiffness[joint].empty() && trial_.stiffness[joint][k] <= 0)
    return std::numeric_limits<double>::quiet_NaN();
  return stepper_.duty(reading.node, seenAt(reading).shown);
}

double Playback::torqueIn(const Reading& reading, const Seen& seen) const {
  return reading.seen ? stepper_.torqueAt(reading.node, seen.shown, seen.rate)
                      : stepper_.torque(reading.node);
}

double Playback::currentIn(const Reading& reading) const {
  const Seen seen = seenAt(reading);
  const double motor = torqueIn(reading, seen) / stepper_.torqueConstant(reading.node);
  return reading.ofSupply ? stepper_.supplyCurrent(reading.node, motor, seen.rate) : motor;
}

}  // namespace plumbline::gap
