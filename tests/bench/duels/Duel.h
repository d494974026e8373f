#pragma once
#include <array>
#include <cstdint>
#include <string>

#include "TrainedGame.h"

namespace plumbline::bench {

/// The two teams of a duel and where their programs are.
struct DuelOptions {
  std::string programs;   ///< folder of simulator and defenders
  std::string attackers;  ///< folder of the attackers' program, whose configuration is beside it
  std::string defence;    ///< modules.cfg of the defenders
  std::string scratch;    ///< folder for ports and logs
};

enum class DuelEnd { goal, ownGoal, overTheirLine, overASide, ownHalf, timeUp };
constexpr std::array<const char*, 6> duelEndNames = {
    "goal", "own goal", "over their line", "over a side line", "in the own half", "time up"};

/// What became of a duel.
struct DuelResult {
  DuelEnd end = DuelEnd::timeUp;
  double nearest = 0;  ///< share of the time in which the robot nearest to the ball is an attacker
  int falls = 0, charging = 0, touching = 0;  ///< of the attackers
};

/// Two teams of three on a simulator of their own. One, the left team, has the ball before the other's goal.
class Duel {
public:
  static constexpr double longest = 20;  ///< [s]

  /// Starts simulator and agents. Throws std::runtime_error, one line.
  Duel(const DuelOptions& options, std::uint64_t seed);
  /// Places by lot: the ball 1 to 6 m before the goal, a robot of each team at it, the others near. It plays
  /// on until a goal, until the ball leaves the other half, or the time is up. Throws std::runtime_error, one
  /// line, if a program has ended.
  DuelResult play(std::uint64_t seed);

private:
  void place(std::uint64_t seed);

  TrainedGame game_;
};

}  // namespace plumbline::bench
