#pragma once
#include "representations/infrastructure/GameState.h"

namespace plumbline {

/// Whether the opponents bring the ball into play, so that the own team keeps its distance.
inline bool isOpponentRestart(TeamPlayMode mode) {
  switch (mode) {
    case TeamPlayMode::kickOffOpponent:
    case TeamPlayMode::kickInOpponent:
    case TeamPlayMode::cornerOpponent:
    case TeamPlayMode::goalKickOpponent:
    case TeamPlayMode::freeKickOpponent:
    case TeamPlayMode::directFreeKickOpponent:
    case TeamPlayMode::passOpponent:
      return true;
    default:
      return false;
  }
}

/// Whether the own team brings it into play; who does must not be the next to touch it.
inline bool isOwnRestart(TeamPlayMode mode) {
  switch (mode) {
    case TeamPlayMode::kickOffOwn:
    case TeamPlayMode::kickInOwn:
    case TeamPlayMode::cornerOwn:
    case TeamPlayMode::goalKickOwn:
    case TeamPlayMode::freeKickOwn:
    case TeamPlayMode::directFreeKickOwn:
      return true;
    default:
      return false;
  }
}

}  // namespace plumbline
