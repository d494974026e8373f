#pragma once
#include <array>
#include <optional>
#include <string_view>

namespace plumbline::simspark {

/// Play modes by the league's index; the monitor sends the index, agents get the name.
enum class PlayMode : int {
  beforeKickOff,
  kickOffLeft,
  kickOffRight,
  playOn,
  kickInLeft,
  kickInRight,
  cornerKickLeft,
  cornerKickRight,
  goalKickLeft,
  goalKickRight,
  offsideLeft,
  offsideRight,
  gameOver,
  goalLeft,
  goalRight,
  freeKickLeft,
  freeKickRight,
  directFreeKickLeft,
  directFreeKickRight,
  passLeft,
  passRight
};

constexpr std::array<std::string_view, 21> playModeNames = {"BeforeKickOff",
                                                            "KickOff_Left",
                                                            "KickOff_Right",
                                                            "PlayOn",
                                                            "KickIn_Left",
                                                            "KickIn_Right",
                                                            "corner_kick_left",
                                                            "corner_kick_right",
                                                            "goal_kick_left",
                                                            "goal_kick_right",
                                                            "offside_left",
                                                            "offside_right",
                                                            "GameOver",
                                                            "Goal_Left",
                                                            "Goal_Right",
                                                            "free_kick_left",
                                                            "free_kick_right",
                                                            "direct_free_kick_left",
                                                            "direct_free_kick_right",
                                                            "pass_left",
                                                            "pass_right"};

constexpr std::string_view playModeName(PlayMode mode) {
  return playModeNames[static_cast<std::size_t>(mode)];
}

constexpr std::optional<PlayMode> playModeByName(std::string_view name) {
  for (std::size_t i = 0; i < playModeNames.size(); ++i)
    if (playModeNames[i] == name) return static_cast<PlayMode>(i);
  return std::nullopt;
}

}  // namespace plumbline::simspark
