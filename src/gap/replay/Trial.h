#pragma once
#include <cmath>
#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "robot/Mechanism.h"

namespace plumbline::gap {

/// Kind of a measured channel; joint or place and axis say which one.
enum class SignalKind { position, velocity, torque, current, duty, gyro, accelerometer, force, truth };

/// Whether it is what a motor gives: its duty, torque or current.
constexpr bool isEffort(SignalKind kind) {
  return kind == SignalKind::torque || kind == SignalKind::current || kind == SignalKind::duty;
}

/// A measured channel of a trial: one value per cycle, NaN where lost.
struct Signal {
  std::string name;  ///< the contract's: pos.LKneePitch
  SignalKind kind = SignalKind::position;
  int joint = -1;  ///< of the mechanism, or -1
  int place = -1;  ///< foot for force
  int axis = 0;    ///< 0..2 of gyro, accelerometer; corner of force; 0..6 of truth (x y z qw qx qy qz)
  bool unsignedValue = false;
  std::vector<double> values;
  bool ofSupply = false;  ///< of a current: the supply's and not the motor's, see CurrentSide.h
};

/// The measured state of the robot in a cycle, from which a replay restarts.
struct Restart {
  std::size_t cycle = 0;
  std::vector<double> position, speed;  ///< per joint, as its encoder shows [rad, rad/s]; NaN: as replayed
  std::vector<double> load;             ///< per foot: its share of the load of all feet
};

/// A run prepared for replay on one mechanism: times, commands, measurements.
struct Trial {
  std::string name;       ///< for people: the run's folder, and which part of it
  std::string recording;  ///< the run's folder; the same for all segments of one recording
  std::string motion;     ///< free text; runs with the same text are repeats of each other
  /// Motion of the whole recording, the same for all its segments; empty: unknown.
  std::string recordedMotion;
  /// The nominal robot with the servo gains of this run.
  std::shared_ptr<const Mechanism> robot;
  bool freeBase = false;
  double heading = 0;        ///< [rad]
  std::vector<double> time;  ///< per cycle [s], strictly rising
  /// Per joint, per cycle: the command that is valid from that cycle on [rad]; empty where never commanded.
  std::vector<std::vector<double>> command;
  /// Per joint, per cycle: target of the servo of a joint that was never commanded [rad]. It is the measured
  /// position (a person or another program moved the joint), else 0 or the limit nearest to 0. It cannot be
  /// lost like a command. Empty for a commanded joint; the whole list is empty if all are.
  std::vector<std::vector<double>> followed;
  /// Per joint, per cycle: speed and torque sent with the position, or instead of it [rad/s, N m]; empty for
  /// a joint without; the whole list is empty if no joint has them.
  std::vector<std::vector<double>> commandSpeed, commandTorque;
  bool linearCommands = false;                 ///< see Run::linearCommands
  std::vector<std::vector<double>> stiffness;  ///< empty: 1 throughout
  std::vector<std::vector<double>> voltage;    ///< empty: as the servo table says [V]
  /// Per joint, relative to the cycle's time [s]; effortAt empty: 0.
  std::vector<double> commandAt, positionAt, velocityAt, effortAt;
  std::vector<Signal> signals;
  /// Columns that were recorded and that no replay has a use for, a line each for people.
  std::vector<std::string> unused;
  /// Restarts of a walking robot (see Restarts.h) or of windows (inference/WindowStarts.h), in ascending
  /// order; none: replayed in one piece.
  std::vector<Restart> restarts;
  /// Per cycle: its commands never came; empty: of none is it known. Found by a diagnosis, not recorded.
  std::vector<std::uint8_t> lost;
  /// Per cycle of a walking robot: no foot is about to land or has just landed or lifted off; else empty.
  std::vector<std::uint8_t> betweenSteps;

  std::size_t cycles() const { return time.size(); }
  /// Target of a joint's servo, per cycle: its commands, or what it follows without commands.
  const std::vector<double>& targets(std::size_t joint) const {
    return command[joint].empty() && joint < followed.size() ? followed[joint] : command[joint];
  }
};

/// A joint's measured position; null where it is not measured.
inline const Signal* positionOf(const Trial& trial, int joint) {
  for (const Signal& signal : trial.signals)
    if (signal.kind == SignalKind::position && signal.joint == joint) return &signal;
  return nullptr;
}

/// Slope of a measured signal at a cycle, by central difference [its unit per second]; 0 at the ends and next
/// to gaps.
inline double rateAt(const Trial& trial, const Signal& signal, std::size_t cycle) {
  if (cycle == 0 || cycle + 1 >= trial.cycles()) return 0;
  const double rate =
      (signal.values[cycle + 1] - signal.values[cycle - 1]) / (trial.time[cycle + 1] - trial.time[cycle - 1]);
  return std::isfinite(rate) ? rate : 0;
}

}  // namespace plumbline::gap
