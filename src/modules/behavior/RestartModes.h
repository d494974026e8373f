#pragma once
#include "representations/infrastructure/GameState.h"

namespace plumbline {

/// Whether the opponents bring the ball into play, so that the own team keeps its distance.
inline bool isOpponentRestart(PlayMode mode) {
  switch (mode) {
    case PlayMode::kickOffOpponent:
    case PlayMode::kickInOpponent:
    case PlayMode::cornerOpponent:
    case PlayMode::goalKickOpponent:
    case PlayMode::freeKickOpponent:
    case PlayMode::directFreeKickOpponent:
    case PlayMode::passOpponent:
      return true;
    default:
      return false;
  }
}

/// Whether the own team brings it into play; who does must not be the next to touch it.
inline bool isOwnRestart(PlayMode mode) {
  switch (mode) {
    case PlayMode::kickOffOwn:
    case PlayMode::kickInOwn:
    case PlayMode::cornerOwn:
    case PlayMode::goalKickOwn:
    case PlayMode::freeKickOwn:
    case PlayMode::directFreeKickOwn:
      return true;
    default:
      return false;
  }
}

}  // namespace plumbline
