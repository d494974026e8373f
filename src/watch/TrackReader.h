#pragma once
#include <string>
#include <vector>

#include "math/Types.h"

namespace plumbline::watch {

/// A player in a track.
struct TrackPlayer {
  bool left = false;  ///< of the team that plays from left to right
  int number = 0;
  Vec2 place = Vec2::Zero();  ///< [m, server's field]
  bool stands = true;         ///< its torso is nearer to upright than to lying
};

/// Where everybody was at a time of a game.
struct TrackMoment {
  double time = 0;     ///< on the game's clock [s]
  std::string mode{};  ///< the server's play mode, as PlayOn
  Vec2 ball = Vec2::Zero();
  std::vector<TrackPlayer> players{};
};

/// Reads what GameTrack has written. Throws std::runtime_error "cannot read FILE: REASON" or "FILE:LINE: what
/// is wrong".
std::vector<TrackMoment> readTrack(const std::string& file);

}  // namespace plumbline::watch
