#pragma once
#include <cstdint>

#include "framework/Representation.h"

namespace plumbline {

enum class TeamPlayMode : std::uint8_t {
  beforeKickOff,
  kickOffOwn,
  kickOffOpponent,
  playOn,
  kickInOwn,
  kickInOpponent,
  cornerOwn,
  cornerOpponent,
  goalKickOwn,
  goalKickOpponent,
  offsideOwn,
  offsideOpponent,
  gameOver,
  goalOwn,
  goalOpponent,
  freeKickOwn,
  freeKickOpponent,
  directFreeKickOwn,
  directFreeKickOpponent,
  passOwn,
  passOpponent,
  unknown
};

/// The referee's state, seen from the own team.
REPRESENTATION(GameState)
class GameState : public GameStateBase {
public:
  TeamPlayMode playMode = TeamPlayMode::unknown;
  double time = 0;  ///< game clock [s]
  int ownScore = 0;
  int opponentScore = 0;
  void stream(InStream* in, OutStream* out) override {
    STREAM(playMode);
    STREAM(time);
    STREAM(ownScore);
    STREAM(opponentScore);
  }
};

}  // namespace plumbline
