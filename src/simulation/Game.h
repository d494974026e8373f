#pragma once
#include <array>
#include <cstddef>
#include <string>

#include "simspark/PlayMode.h"
#include "simspark/TeamSide.h"

namespace plumbline::simulation {

using simspark::PlayMode;
using simspark::TeamSide;

/// State of the game, as the referee keeps it and everyone is told.
struct Game {
  PlayMode mode = PlayMode::beforeKickOff;
  double time = 0;            ///< game clock [s]; stands before kick-off and after the end
  double standingTime = 0;    ///< since the last change to a mode in which the clock stands [s]
  double lastModeChange = 0;  ///< game time of it [s]
  int half = 1;
  std::array<int, 2> score{};          ///< left, right
  std::array<std::string, 2> teams{};  ///< left, right; empty: not there yet

  static std::size_t index(TeamSide side) { return side == TeamSide::right ? 1 : 0; }

  bool clockStands() const { return mode == PlayMode::beforeKickOff || mode == PlayMode::gameOver; }
  /// Time in this mode [s].
  double modeTime() const { return clockStands() ? standingTime : time - lastModeChange; }
  void setMode(PlayMode next);
  void advance(double seconds) { (clockStands() ? standingTime : time) += seconds; }
};

inline void Game::setMode(PlayMode next) {
  if (next == mode) return;
  mode = next;
  lastModeChange = time;
  standingTime = 0;
}

}  // namespace plumbline::simulation
