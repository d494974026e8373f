#include "gap/blind/Planting.h"

#include <cmath>
#include <limits>
#include <memory>
#include <stdexcept>

#include "gap/effects/Effects.h"
#include "gap/inference/Groups.h"
#include "gap/inference/Strengths.h"
#include "gap/replay/Replay.h"
#include "gap/replay/TrialOf.h"

namespace plumbline::gap {

namespace {

constexpr double leastRotor = 2e-5;  ///< [kg m^2]
constexpr double leastMass = 5e-3;   ///< [kg]

void divide(std::optional<double>& x, double v) {
  if (x) *x /= v;
}

/// Takes a cause out of a joint's servo, in the robot's model and where the runs override it.
void takeOutOfJoint(RealRecordings& base, std::string_view id, std::size_t at, double v) {
  Mechanism::Joint& joint = base.robot.joints[at];
  Servo& servo = joint.servo;
  std::vector<ServoOverride*> overrides;
  for (Run& run : base.runs)
    if (const auto own = run.servo.find(joint.name); own != run.servo.end())
      overrides.push_back(&own->second);
  if (id == "servo_gain") {
    servo.kp /= v;
    servo.kpFirmware /= v;
    for (ServoOverride* own : overrides) divide(own->kp, v), divide(own->kpFirmware, v);
  } else if (id == "servo_damping") {
    servo.kd /= v;
    // Of a DC motor: push kt / R stays, the back EMF's kt^2 / R shrinks.
    servo.kt /= v;
    servo.R /= v;
    for (ServoOverride* own : overrides) divide(own->kd, v);
  } else if (id == "torque_limit") {
    joint.maxTorque /= v;
    for (ServoOverride* own : overrides) divide(own->maxTorque, v);
  } else if (id == "speed_limit") {
    joint.maxSpeed /= v;
    for (ServoOverride* own : overrides) divide(own->maxSpeed, v);
  } else if (id == "rotor_inertia") {
    servo.armature -= v;
    for (ServoOverride* own : overrides)
      if (own->armature) *own->armature -= v;
    if (servo.armature < leastRotor) throw std::runtime_error("no rotor would be left");
    for (const ServoOverride* own : overrides)
      if (own->armature && *own->armature < leastRotor) throw std::runtime_error("no rotor would be left");
  }
}

/// The same for a link.
void takeOutOfLink(Mechanism& robot, std::string_view id, const Place& place, double v) {
  Mechanism::Link& link = robot.links[static_cast<std::size_t>(place.index)];
  if (id == "link_mass") {
    link.mass -= v;
    if (link.mass < leastMass) throw std::runtime_error("no mass would be left");
  } else if (id == "com_offset") {
    link.com[place.axis - 'x'] -= v;
  } else if (id == "link_length") {
    link.com /= v;
    for (Mechanism::Joint& joint : robot.joints)
      if (joint.parent == place.index) joint.origin /= v;
    for (Mechanism::Foot& foot : robot.feet)
      if (foot.link == place.index) foot.soleCentre.z() /= v;
  }
}

void shift(Run& run, const std::string& channel, double by) {
  if (const auto column = run.channels.find(channel); column != run.channels.end())
    for (double& value : column->second) value += by;
}

/// The run says that commands reached the servos earlier than they did.
void hasten(Run& run, const Mechanism& robot, const Place& place, double by) {
  if (place.site == Site::everywhere) {
    if (run.timing.empty()) run.timing["*"] = {};
    for (auto& [joint, timing] : run.timing) timing.cmdAt -= by;
    return;
  }
  std::map<std::string, JointTiming> timing;
  for (const Mechanism::Joint& joint : robot.joints) timing[joint.name] = run.timingOf(joint.name);
  timing[place.at].cmdAt -= by;
  run.timing = std::move(timing);
}

/// A target that is too low by v / kp pulls as v does, while nothing saturates.
void lowerTarget(RealRecordings& base, std::size_t at, double v) {
  const Mechanism::Joint& joint = base.robot.joints[at];
  if (joint.servo.model != Servo::Model::position) throw std::runtime_error("its law is not linear");
  for (Run& run : base.runs) {
    if (run.find(ChannelKind::stiffness, joint.name)) throw std::runtime_error("the motor is off at times");
    const auto own = run.servo.find(joint.name);
    const double kp = own == run.servo.end() ? joint.servo.kp : own->second.kp.value_or(joint.servo.kp);
    shift(run, channelName(ChannelKind::command, joint.name), -v / kp);
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

/// Whether the joint was sent commands and its position read, in a run at least.
bool wasRecorded(const RealRecordings& base, int joint) {
  const std::string& name = base.robot.joints[static_cast<std::size_t>(joint)].name;
  for (const Run& run : base.runs)
    if (run.find(ChannelKind::command, name) && run.find(ChannelKind::position, name)) return true;
  return false;
}

bool canBePlanted(const RealRecordings& base, const Effect& effect, const Place& place) {
  const Mechanism& robot = base.robot;
  if (effect.canBeAt && !effect.canBeAt(robot, place)) return false;
  const bool delay = effect.id == "command_delay";
  if (place.site == Site::everywhere) return delay && place.index < 0;
  if (place.site == Site::link) {
    const std::vector<int> chain = robot.chain(place.index);
    return !chain.empty() && wasRecorded(base, chain.back());
  }
  const Mechanism::Joint& joint = robot.joints[static_cast<std::size_t>(place.index)];
  if (!wasRecorded(base, place.index) || joint.driver >= 0) return false;
  if (delay) return robot.numJoints() == 1;
  // The law of a DC motor has no limits, and no gain that turns a torque into an angle at any voltage.
  const bool ofLinearLaw =
      effect.id == "torque_limit" || effect.id == "speed_limit" || effect.id == "bias_force";
  return !ofLinearLaw || joint.servo.model == Servo::Model::position;
}

}  // namespace

RealRecordings::RealRecordings(Mechanism model, std::vector<Run> recordings)
    : robot(std::move(model)), runs(std::move(recordings)) {
  for (const Run& run : runs) trials.push_back(trialOf(run, robot));
}

std::vector<Cause> plantsFor(const RealRecordings& base, std::span<const std::string_view> ids) {
  std::vector<Cause> plants;
  for (const std::string_view id : ids) {
    const Effect* effect = findEffect(id);
    for (const Place& place : placesOf(*effect, base.robot))
      if (canBePlanted(base, *effect, place))
        for (const double start : effect->starts)
          plants.push_back({effect, place, start * effect->scaleAt(base.robot, place)});
  }
  return plants;
}

RealRecordings planted(const RealRecordings& base, const Cause& cause) {
  RealRecordings other = base;
  const std::string_view id = cause.effect->id;
  const auto at = static_cast<std::size_t>(std::max(0, cause.place.index));
  if (cause.place.site == Site::link) {
    takeOutOfLink(other.robot, id, cause.place, cause.value);
  } else if (id == "command_delay") {
    for (Run& run : other.runs) hasten(run, other.robot, cause.place, cause.value);
  } else if (id == "joint_offset") {
    // The servo closes its loop over its encoder: its target is in the encoder's angle, too.
    Mechanism::Joint& joint = other.robot.joints[at];
    joint.lower -= cause.value;
    joint.upper -= cause.value;
    for (Run& run : other.runs)
      for (const ChannelKind kind : {ChannelKind::command, ChannelKind::position})
        shift(run, channelName(kind, joint.name), -cause.value);
  } else if (id == "bias_force") {
    lowerTarget(other, at, cause.value);
  } else {
    takeOutOfJoint(other, id, at, cause.value);
  }
  return {std::move(other.robot), std::move(other.runs)};
}

std::vector<double> residualsOf(const RealRecordings& base, const Explanation& causes) {
  std::vector<double> residuals;
  for (const Trial& trial : base.trials) {
    const Prediction prediction = replay(plantOf(trial, causes), trial);
    for (std::size_t s = 0; s < trial.signals.size(); ++s) {
      if (trial.signals[s].kind != SignalKind::position || prediction.values[s].empty()) continue;
      for (std::size_t k = firstScored(trial); k < trial.cycles(); ++k)
        residuals.push_back(trial.signals[s].values[k] - prediction.values[s][k]);
    }
  }
  return residuals;
}

std::size_t residualCycles(const Trial& trial) { return trial.cycles() - firstScored(trial); }

double differenceOf(const std::vector<double>& a, const std::vector<double>& b) {
  double squares = 0, n = 0;
  for (std::size_t k = 0; k < a.size(); ++k)
    if (const double d = a[k] - b[k]; std::isfinite(d)) squares += d * d, ++n;
  return n > 0 ? std::sqrt(squares / n) : 0;
}

Cause sized(const RealRecordings& base, Cause cause, double change) {
  const std::vector<double> before = residualsOf(base, {});
  const double nominal = cause.effect->nominal;
  const Bounds bounds = cause.effect->boundsAt(base.robot, cause.place);
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

double leftOfPlant(const RealRecordings& base, const RealRecordings& planted, const Cause& cause) {
  const std::vector<double> wanted = residualsOf(base, {}), nominal = residualsOf(planted, {});
  const double whole = differenceOf(wanted, nominal);
  double left = 1, strength = cause.effect->strengthOf(cause.value);
  for (int round = 0; round < 6; ++round) {
    const std::vector<double> here = residualsOf(planted, {withStrength(planted.robot, cause, strength)});
    left = std::min(left, differenceOf(wanted, here) / whole);
    const double step = 0.02 * strength;
    const std::vector<double> slope =
        minus(residualsOf(planted, {withStrength(planted.robot, cause, strength + step)}), here);
    const double square = along(slope, slope);
    if (!(square > 0)) break;
    strength += step * along(minus(wanted, here), slope) / square;
  }
  return left;
}

}  // namespace plumbline::gap
