#include "gap/replay/TrialOf.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "gap/replay/Restarts.h"
#include "gap/replay/TruePose.h"
#include "gap/run/CommandCheck.h"

namespace plumbline::gap {

namespace {

std::optional<SignalKind> kindOf(ChannelKind kind) {
  switch (kind) {
    case ChannelKind::position:
      return SignalKind::position;
    case ChannelKind::velocity:
      return SignalKind::velocity;
    case ChannelKind::torque:
      return SignalKind::torque;
    case ChannelKind::current:
      return SignalKind::current;
    case ChannelKind::duty:
      return SignalKind::duty;
    case ChannelKind::gyro:
      return SignalKind::gyro;
    case ChannelKind::acceleration:
      return SignalKind::accelerometer;
    case ChannelKind::force:
      return SignalKind::force;
    case ChannelKind::truth:
      return SignalKind::truth;
    default:
      return std::nullopt;
  }
}

/// Finds the signal's joint, foot and axis; false where the robot has no such place.
bool locate(const Mechanism& robot, const std::string& place, Signal& signal) {
  switch (signal.kind) {
    case SignalKind::gyro:
    case SignalKind::accelerometer:
      signal.axis = place == "x" ? 0 : place == "y" ? 1 : 2;
      return robot.hasImu;
    case SignalKind::truth: {
      const auto* const found = std::ranges::find(poseAxes, place);
      signal.axis = static_cast<int>(found - poseAxes.begin());
      return found != poseAxes.end();
    }
    case SignalKind::force: {
      const auto dot = place.find('.');
      signal.place = robot.footIndex(place.substr(0, dot));
      if (signal.place < 0 || dot == std::string::npos) return false;
      const auto& sensors = robot.feet[static_cast<std::size_t>(signal.place)].sensors;
      const auto found =
          std::ranges::find(sensors, place.substr(dot + 1), [](const auto& sensor) { return sensor.corner; });
      signal.axis = static_cast<int>(found - sensors.begin());
      return found != sensors.end();
    }
    default:
      signal.joint = robot.jointIndex(place);
      return signal.joint >= 0;
  }
}

/// A quaternion and its negative are one rotation: readings keep the sign that follows from the one before,
/// and the first has w >= 0 (or the first of x, y, z that is not 0).
void unwindQuaternion(std::vector<Signal>& signals) {
  std::array<std::vector<double>*, 4> q{};
  for (Signal& signal : signals)
    if (signal.kind == SignalKind::truth && signal.axis >= 3)
      q[static_cast<std::size_t>(signal.axis - 3)] = &signal.values;
  if (std::ranges::find(q, nullptr) != q.end()) return;
  std::array<double, 4> last{1, 0, 0, 0};
  for (std::size_t k = 0; k < q[0]->size(); ++k) {
    double dot = 0;
    for (std::size_t i = 0; i < 4; ++i) dot += last[i] * (*q[i])[k];
    if (!std::isfinite(dot)) continue;
    for (std::size_t i = 0; i < 4; ++i) {
      if (dot < 0) (*q[i])[k] *= -1;
      last[i] = (*q[i])[k];
    }
  }
}

/// A joint without commands of its own follows its driver, or goes where it was seen, or stays.
void moveTheUncommanded(const Run& run, const Mechanism& nominal, Trial& trial) {
  trial.followed.resize(nominal.joints.size());
  for (std::size_t j = 0; j < nominal.joints.size(); ++j) {
    if (!trial.command[j].empty()) continue;
    const Mechanism::Joint& joint = nominal.joints[j];
    const auto* const seen = run.find(ChannelKind::position, joint.name);
    const auto driver = static_cast<std::size_t>(joint.driver);
    if (joint.driver >= 0 && !trial.command[driver].empty()) {
      trial.command[j] = trial.command[driver];
      for (double& value : trial.command[j]) value = joint.driven(value);
    } else if (joint.driver >= 0 && driver < j &&
               (!seen || run.find(ChannelKind::position, nominal.joints[driver].name))) {
      trial.followed[j] = trial.followed[driver];
      for (double& value : trial.followed[j]) value = joint.driven(value);
    } else if (seen) {
      trial.followed[j] = *seen;
    } else {
      trial.followed[j].assign(trial.cycles(), std::clamp(0.0, joint.lower, joint.upper));
    }
  }
}

bool commanded(const Run& run, const std::string& joint) {
  return run.find(ChannelKind::command, joint) || wasSentSpeedOrTorque(run, joint);
}

/// Torques that were sent to a joint, or its currents times the torque per ampere; empty: none.
std::vector<double> torquesSent(const Run& run, const Mechanism::Joint& joint) {
  if (const auto* torques = run.find(ChannelKind::commandTorque, joint.name)) return *torques;
  std::vector<double> torques;
  if (const auto* currents = run.find(ChannelKind::commandCurrent, joint.name)) torques = *currents;
  for (double& value : torques) value *= joint.servo.kt;
  return torques;
}

/// Takes speeds, torques and currents that were sent. A joint that was sent these and no position has no
/// position gain, and damping only where it was sent speeds. Returns the robot as it is driven then.
Mechanism driveByTorque(const Run& run, Mechanism robot, Trial& trial) {
  for (std::size_t j = 0; j < robot.joints.size(); ++j) {
    Mechanism::Joint& joint = robot.joints[j];
    const bool dcMotor = joint.servo.model == Servo::Model::dcMotor,
               positions = run.find(ChannelKind::command, joint.name) != nullptr;
    if (dcMotor && positions) continue;
    if (const auto* speeds = run.find(ChannelKind::commandSpeed, joint.name); speeds && !dcMotor)
      trial.commandSpeed[j] = *speeds;
    trial.commandTorque[j] = torquesSent(run, joint);
    if (positions || (trial.commandSpeed[j].empty() && trial.commandTorque[j].empty())) continue;
    joint.servo.followsTorque = dcMotor;
    joint.servo.kp = 0;
    if (trial.commandSpeed[j].empty()) joint.servo.kd = 0;
    trial.command[j].assign(trial.cycles(), 0);
  }
  return robot;
}

bool isPositionServo(const Mechanism& robot, const std::string& joint) {
  const int index = robot.jointIndex(joint);
  return index >= 0 && robot.joints[static_cast<std::size_t>(index)].servo.model == Servo::Model::position;
}

}  // namespace

std::string unusedLine(const std::string& column, const std::string& why) {
  return column.substr(0, column.find('.')) + ".* is not used: " + why;
}

Trial trialOf(const Run& run, const Mechanism& nominal) {
  Trial trial;
  trial.name = trial.recording = run.folder;
  trial.motion = trial.recordedMotion = run.motion;
  trial.robot = std::make_shared<Mechanism>(withServo(nominal, run));
  trial.freeBase = run.freeBase;
  trial.heading = run.heading.value_or(0);
  trial.time = run.t;
  const std::size_t n = nominal.joints.size();
  trial.command.resize(n);
  trial.stiffness.resize(n);
  trial.voltage.resize(n);
  trial.commandSpeed.resize(n);
  trial.commandTorque.resize(n);
  trial.linearCommands = run.linearCommands;
  for (std::size_t j = 0; j < n; ++j) {
    const std::string& name = nominal.joints[j].name;
    const JointTiming timing = run.timingOf(name);
    trial.commandAt.push_back(timing.cmdAt);
    trial.positionAt.push_back(timing.posAt);
    trial.velocityAt.push_back(timing.velAt);
    trial.effortAt.push_back(timing.effortAt);
    if (const auto* values = run.find(ChannelKind::command, name)) trial.command[j] = *values;
    if (run.find(ChannelKind::stiffness, name)) trial.stiffness[j] = run.stiffnessOf(name);
    if (const auto* values = run.find(ChannelKind::voltage, name)) trial.voltage[j] = *values;
  }
  trial.robot = std::make_shared<Mechanism>(driveByTorque(run, *trial.robot, trial));
  moveTheUncommanded(run, nominal, trial);
  bool anyPosition = false;
  for (const auto& [column, values] : run.channels) {
    const auto channel = parseChannel(column);
    const auto kind = channel ? kindOf(channel->kind) : std::nullopt;
    if (channel && channel->kind == ChannelKind::temperature)
      trial.unused.push_back(unusedLine(column, "no model here predicts it"));
    if (channel && channel->kind == ChannelKind::voltage && isPositionServo(nominal, channel->place))
      trial.unused.push_back(unusedLine(column, "the law of a position servo has no supply"));
    if (!kind) continue;
    Signal signal;
    signal.name = column;
    signal.kind = *kind;
    if (!locate(nominal, channel->place, signal)) continue;
    if (*kind == SignalKind::position && !commanded(run, channel->place)) continue;
    signal.unsignedValue = run.isUnsigned(column);
    signal.values = values;
    anyPosition = anyPosition || *kind == SignalKind::position;
    trial.signals.push_back(std::move(signal));
  }
  unwindQuaternion(trial.signals);
  cutIntoSteps(trial);
  if (!anyPosition) {
    throw RunError(run.folder +
                   ": no joint has both a command and a measured position; record cmd.JOINT and pos.JOINT");
  }
  return trial;
}

}  // namespace plumbline::gap
