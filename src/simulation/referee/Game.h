#pragma once
#include <array>
#include <cstddef>
#include <string>
#include <utility>

#include "simspark/PlayMode.h"
#include "simspark/TeamSide.h"
#include "simulation/referee/Fouls.h"

namespace plumbline::simulation {

using simspark::PlayMode;
using simspark::TeamSide;

/// State of the game, as the referee keeps it and everyone receives it.
struct Game {
  PlayMode mode = PlayMode::beforeKickOff;
  double time = 0;            ///< game clock [s]; stopped before kick-off and after the end
  double stoppedTime = 0;     ///< since the last change to a mode in which the clock is stopped [s]
  double lastModeChange = 0;  ///< game time of it [s]
  int half = 1;
  std::array<int, 2> score{};          ///< left, right
  std::array<std::string, 2> teams{};  ///< left, right; empty: not there yet
  Fouls fouls;
  /// How long a side has still to wait for a goal after its pass mode [s]; 0: not at all.
  std::array<double, 2> passScoreWait{};

  static std::size_t index(TeamSide side) { return side == TeamSide::right ? 1 : 0; }

  bool clockIsStopped() const { return mode == PlayMode::beforeKickOff || mode == PlayMode::gameOver; }
  /// Time in this mode [s].
  double modeTime() const { return clockIsStopped() ? stoppedTime : time - lastModeChange; }
  void setMode(PlayMode next);
  void advance(double seconds) { (clockIsStopped() ? stoppedTime : time) += seconds; }
  /// The teams change ends, with their goals.
  void swapSides() {
    std::swap(teams[0], teams[1]);
    std::swap(score[0], score[1]);
    std::swap(passScoreWait[0], passScoreWait[1]);
  }
};

/// A mode of the left team, or its twin of the right one, which follows it in the list.
constexpr PlayMode modeOf(PlayMode left, TeamSide side) {
  return static_cast<PlayMode>(static_cast<int>(left) + (side == TeamSide::right ? 1 : 0));
}
/// The team a mode like goalLeft belongs to; none: kickOffLeft is not its left twin, nor is it the right one.
constexpr TeamSide sideOf(PlayMode mode, PlayMode left) {
  return mode == left                            ? TeamSide::left
         : mode == modeOf(left, TeamSide::right) ? TeamSide::right
                                                 : TeamSide::none;
}

inline void Game::setMode(PlayMode next) {
  if (next == mode) return;
  mode = next;
  lastModeChange = time;
  stoppedTime = 0;
}

}  // namespace plumbline::simulation
