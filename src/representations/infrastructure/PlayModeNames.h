#pragma once
#include <array>
#include <string>

#include "representations/infrastructure/GameState.h"

namespace plumbline {

/// The words for play modes in files, in the order of PlayMode.
constexpr std::array<const char*, static_cast<std::size_t>(PlayMode::unknown) + 1> playModeNames = {
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

inline const char* playModeName(PlayMode mode) { return playModeNames.at(static_cast<std::size_t>(mode)); }

}  // namespace plumbline
