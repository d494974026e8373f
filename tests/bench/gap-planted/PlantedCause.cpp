#include "PlantedCause.h"

#include <cmath>
#include <limits>
#include <memory>
#include <stdexcept>

#include "gap/effects/Effects.h"
#include "gap/inference/Groups.h"
#include "gap/inference/Strengths.h"
#include "gap/replay/Replay.h"

namespace plumbline::bench {

using gap::Cause;
using gap::Effect;
using gap::Place;
using gap::Signal;
using gap::SignalKind;
using gap::Site;
using gap::Trial;

namespace {

/// Takes a cause out of a robot's model; of the data only joint offset and delay are.
void takeOut(Mechanism& robot, const Cause& cause) {
  const std::string_view id = cause.effect->id;
  const double v = cause.value;
  const auto at = static_cast<std::size_t>(cause.place.index);
  if (id == "servo_gain") {
    Servo& servo = robot.joints[at].servo;
    servo.kp /= v;
    servo.kpFirmware /= v;
  } else if (id == "servo_damping") {
    Servo& servo = robot.joints[at].servo;
    servo.kd /= v;
    // Push kt / R stays, the back EMF's kt^2 / R shrinks.
    servo.kt /= v;
    servo.R /= v;
  } else if (id == "rotor_inertia") {
    robot.joints[at].servo.armature -= v;
    if (robot.joints[at].servo.armature < 2e-5) throw std::runtime_error("no rotor would be left");
  } else if (id == "link_mass") {
    robot.links[at].mass -= v;
    if (robot.links[at].mass < 5e-3) throw std::runtime_error("no mass would be left");
  } else if (id == "com_offset") {
    robot.links[at].com[cause.place.axis - 'x'] -= v;
  } else if (id == "joint_offset") {
    robot.joints[at].lower -= v;
    robot.joints[at].upper -= v;
  } else if (id != "command_delay") {
    throw std::runtime_error("cannot be planted: " + std::string(id));
  }
}

double along(const std::vector<double>& a, const std::vector<double>& b) {
  double sum = 0;
  for (std::size_t k = 0; k < a.size(); ++k)
    if (std::isfinite(a[k] * b[k])) sum += a[k] * b[k];
  return sum;
}

std::vector<double> minus(std::vector<double> a, const std::vector<double>& b) {
  for (std::size_t k = 0; k < a.size(); ++k) a[k] -= b[k];
  return a;
}

}  // namespace

std::vector<Cause> plantsFor(const Base& base) {
  std::vector<Cause> plants;
  for (const std::string_view id : {"servo_gain", "servo_damping", "rotor_inertia", "link_mass", "com_offset",
                                    "joint_offset", "command_delay"}) {
    const Effect* effect = gap::findEffect(id);
    for (const Place& place : gap::placesOf(*effect, base.robot)) {
      if (effect->canBeAt && !effect->canBeAt(base.robot, place)) continue;
      if (place.site == Site::link && base.robot.chain(place.index).empty()) continue;
      if (place.site == Site::everywhere && id != "command_delay") continue;
      if (place.site != Site::everywhere && id == "command_delay" && base.robot.numJoints() > 1) continue;
      for (const double start : effect->starts)
        plants.push_back({effect, place, start * effect->scaleAt(base.robot, place)});
    }
  }
  return plants;
}

Base planted(const Base& base, const Cause& cause) {
  Base other = base;
  takeOut(other.robot, cause);
  for (Trial& trial : other.trials) {
    Mechanism robot = *trial.robot;
    takeOut(robot, cause);
    trial.robot = std::make_shared<Mechanism>(std::move(robot));
    const auto at = static_cast<std::size_t>(std::max(0, cause.place.index));
    if (cause.effect->id == "command_delay") {
      // The log says that a command reached the servo earlier than it did.
      for (std::size_t joint = 0; joint < trial.commandAt.size(); ++joint)
        if (cause.place.site == Site::everywhere || joint == at) trial.commandAt[joint] -= cause.value;
    } else if (cause.effect->id == "joint_offset") {
      // The servo closes its loop over its encoder: its target is in the encoder's angle, too.
      for (double& command : trial.command[at]) command -= cause.value;
      for (Signal& signal : trial.signals)
        if (signal.kind == SignalKind::position && signal.joint == cause.place.index)
          for (double& value : signal.values) value -= cause.value;
    }
  }
  return other;
}

std::vector<double> residualsOf(const Base& base, const gap::Explanation& causes) {
  std::vector<double> residuals;
  for (const Trial& trial : base.trials) {
    const gap::Prediction prediction = gap::replay(gap::plantOf(trial, causes), trial);
    for (std::size_t s = 0; s < trial.signals.size(); ++s) {
      if (trial.signals[s].kind != SignalKind::position || prediction.values[s].empty()) continue;
      for (std::size_t k = gap::firstScored(trial); k < trial.cycles(); ++k)
        residuals.push_back(trial.signals[s].values[k] - prediction.values[s][k]);
    }
  }
  return residuals;
}

double differenceOf(const std::vector<double>& a, const std::vector<double>& b) {
  double squares = 0, n = 0;
  for (std::size_t k = 0; k < a.size(); ++k)
    if (const double d = a[k] - b[k]; std::isfinite(d)) squares += d * d, ++n;
  return n > 0 ? std::sqrt(squares / n) : 0;
}

Cause sized(const Base& base, Cause cause, double change) {
  const std::vector<double> before = residualsOf(base, {});
  const double nominal = cause.effect->nominal;
  const gap::Bounds bounds = cause.effect->boundsAt(base.robot, cause.place);
  const double end = cause.value > nominal ? bounds.upper : bounds.lower;
  double low = 0, high = 0.01;
  const auto moves = [&](double share) {
    // Ratios go towards their ends by powers.
    cause.value = nominal == 1 ? std::pow(std::max(end, 0.1), share) : nominal + share * (end - nominal);
    try {
      return differenceOf(residualsOf(planted(base, cause), {}), before);
    } catch (const std::runtime_error&) {
      return std::numeric_limits<double>::infinity();
    }
  };
  while (high < 1 && moves(high) < change) low = high, high *= 2;
  for (int round = 0; round < 7; ++round) {
    const double middle = (low + high) / 2;
    (moves(middle) < change ? low : high) = middle;
  }
  const double moved = moves(low);
  if (low >= 0.95 || !(moved > 0.7 * change && moved < 1.4 * change)) cause.value = nominal;
  return cause;
}

double leftOfPlant(const Base& base, const Base& planted, Cause cause) {
  const std::vector<double> wanted = residualsOf(base, {}), nominal = residualsOf(planted, {});
  const double whole = differenceOf(wanted, nominal);
  double left = 1, strength = cause.effect->strengthOf(cause.value);
  for (int round = 0; round < 6; ++round) {
    const std::vector<double> here =
        residualsOf(planted, {gap::withStrength(planted.robot, cause, strength)});
    left = std::min(left, differenceOf(wanted, here) / whole);
    const double step = 0.02 * strength;
    const std::vector<double> slope =
        minus(residualsOf(planted, {gap::withStrength(planted.robot, cause, strength + step)}), here);
    const double square = along(slope, slope);
    if (!(square > 0)) break;
    strength += step * along(minus(wanted, here), slope) / square;
  }
  return left;
}

}  // namespace plumbline::bench
