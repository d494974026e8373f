#pragma once
#include <array>
#include <cstdint>
#include <optional>
#include <string>

#include "TrainedGame.h"
#include "simspark/PlayMode.h"

namespace plumbline::bench {

enum class SetPieceKind { kickOff, kickIn, cornerKick, goalKick, freeKick };
constexpr std::array<const char*, 5> setPieceNames = {"kick-off", "kick-in", "corner kick", "goal kick",
                                                      "free kick"};

struct SetPieceOptions {
  std::string programs;  ///< folder of simulator and players
  std::string others;    ///< modules.cfg of the other team; empty: it plays as ours
  std::string scratch;   ///< folder for ports and logs
  int players = 5;       ///< on each side, with a goalie
};

/// What became of a set piece of the left team.
struct SetPieceResult {
  SetPieceKind kind = SetPieceKind::kickOff;
  bool taken = false;   ///< before the referee dropped the ball
  double seconds = 0;   ///< until it was taken
  bool ours = false;    ///< another player of the team has the next touch
  bool theirs = false;  ///< an opponent has
  double gain = 0;      ///< of the ball towards the other goal, so long after the kick as `gainAfter` [m]
  bool kept = false;    ///< the team has the last touch, so long after the kick as `keptAfter`, or scored
  bool goal = false, against = false, doubleTouch = false;
};

/// Two teams on a simulator of their own; the left one has the set pieces.
class SetPieceGame {
public:
  static constexpr double longest = 20;    ///< after the kick [s]
  static constexpr double gainAfter = 5;   ///< [s]
  static constexpr double keptAfter = 10;  ///< [s]

  SetPieceGame(const SetPieceOptions& options, std::uint64_t seed);
  /// Places by lot; until a goal, until the ball is out of play, or the time is up. Throws
  /// std::runtime_error, one line, if a program has ended.
  SetPieceResult play(SetPieceKind kind, std::uint64_t seed);

private:
  void give(SetPieceKind kind, std::uint64_t seed);
  void place(const Vec2& ball, std::uint64_t seed);

  SetPieceOptions options_;
  TrainedGame game_;
};

/// Plays TRIES set pieces of each kind, or of those of KINDS, and writes build/bench/set-pieces.json and .md.
void measureSetPieces();

}  // namespace plumbline::bench
