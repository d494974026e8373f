#pragma once
#include <array>
#include <string>

#include "representations/infrastructure/GameState.h"

namespace plumbline {

/// The words for play modes in files, in the order of TeamPlayMode.
constexpr std::array<const char*, static_cast<std::size_t>(TeamPlayMode::unknown) + 1> teamPlayModeNames = {
    "beforeKickOff",
    "kickOffOwn",
    "kickOffOpponent",
    "playOn",
    "kickInOwn",
    "kickInOpponent",
    "cornerOwn",
    "cornerOpponent",
    "goalKickOwn",
    "goalKickOpponent",
    "offsideOwn",
    "offsideOpponent",
    "gameOver",
    "goalOwn",
    "goalOpponent",
    "freeKickOwn",
    "freeKickOpponent",
    "directFreeKickOwn",
    "directFreeKickOpponent",
    "passOwn",
    "passOpponent",
    "unknown"};

inline const char* teamPlayModeName(TeamPlayMode mode) {
  return teamPlayModeNames.at(static_cast<std::size_t>(mode));
}

}  // namespace plumbline
