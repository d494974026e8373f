#pragma once
#include <fstream>
#include <string>

#include "simspark/SceneState.h"

namespace plumbline::watch {

/// Where everybody was in a game, as a CSV file: a line for the ball and one for each player, every
/// `interval` of the game's clock while it runs. Columns: time [s], side (ball, left, right), number, x, y
/// [m, server's field], up (upward part of the torso's axis), mode.
class GameTrack {
public:
  static constexpr double interval = 0.5;  ///< [s]

  /// Throws std::runtime_error "cannot write FILE: REASON".
  explicit GameTrack(const std::string& file);
  /// The next scene, in their order. Throws std::runtime_error as above.
  void observe(const simspark::SceneState& scene);

private:
  std::string file_;
  std::ofstream out_;
  double next_ = 0, before_ = 0;  ///< [s]
};

}  // namespace plumbline::watch
