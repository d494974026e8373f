#pragma once
#include <cstdint>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "robot/Mechanism.h"

namespace plumbline::gap {

/// One piece of an excitation program: a wave on some joints that begins and ends at 0 and is added to the
/// posture, or a move that changes the posture for what follows.
struct Segment {
  enum class Kind {
    move,       ///< to `joints` (here absolute positions), smooth at both ends
    triangle,   ///< constant speed in both directions, rounded corners; `cycles` of them
    chirp,      ///< sine whose frequency rises from fromHz to toHz
    steps,      ///< jumps to +1, -1, +1/2, -1/2, 0
    sine,       ///< fromHz; the amplitude grows over the first quarter and falls over the last
    bumps,      ///< the square of such a sine while it is positive, else 0: steps of a foot
    multisine,  ///< `tones` sines between fromHz and toHz, with different phases and frequencies for each
                ///< joint
    fast        ///< random targets at `speed` of each joint's maximal speed, a short step after each
  };
  Kind kind = Kind::sine;
  double start = 0, duration = 0;  ///< [s]
  /// Joint and amplitude of the wave [rad]; a negative one reverses it.
  std::vector<std::pair<int, double>> joints;
  double fromHz = 0.5, toHz = 4;
  double phase = 0;  ///< of sine and bumps, in turns
  int cycles = 1, tones = 12;
  double speed = 0.85;
  std::vector<double> accelerations;  ///< of fast: limit for each of `joints` [rad/s^2]; empty: no limit
  std::uint64_t seed = 1;
};
const char* name(Segment::Kind kind);

/// The project's own walk instead of segments: the request, and how long the robot stands before and after
/// [m/s, rad/s, s].
struct WalkSegment {
  Vec2 velocity = Vec2::Zero();  ///< forward, to the left
  double turn = 0;
  double standBefore = 1, duration = 10, standAfter = 1;
};

/// A program for one robot: what to command when.
struct Excitation {
  std::string name, about;
  bool freeBase = false;
  double heading = 0;           ///< yaw at which a free robot is put down [rad]
  std::vector<double> posture;  ///< at the start, one position per joint [rad]
  std::vector<Segment> segments;
  double duration = 0;  ///< [s]
  /// A walk is closed loop: recordWalk records it, and there is no table of commands.
  std::optional<WalkSegment> walk{};
};

/// What is sent when: commands[joint][i] at t[i] = i / rate.
struct CommandTable {
  std::vector<double> t;                      ///< [s]
  std::vector<std::vector<double>> commands;  ///< [rad], one list per joint of the robot, as long as t
};

/// The commands of a program; throws std::invalid_argument for a walk. Positions are within the joints'
/// limits (limitMargin inside); joints with a driver follow it.
CommandTable playExcitation(const Excitation& excitation, const Mechanism& robot, double rateHz);
constexpr double limitMargin = 0.01;  ///< [rad] or [m], at most a hundredth of the range

/// Torque of each joint against gravity at positions q, with a level, fixed base [N m].
std::vector<double> gravityTorques(const Mechanism& robot, const std::vector<double>& q);

/// Acceleration that each joint reaches at positions q with seven tenths of its torque, against gravity
/// [rad/s^2]; at least a tenth of the value without gravity.
std::vector<double> reachableAccelerations(const Mechanism& robot, const std::vector<double>& q);

}  // namespace plumbline::gap
