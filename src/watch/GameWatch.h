#pragma once
#include <functional>
#include <string>

#include "field/TeamSize.h"
#include "simspark/StandardPorts.h"
#include "watch/GameCounter.h"

namespace plumbline {
class StopSignal;
}

namespace plumbline::watch {

/// How a game ended. Anything but `over` is no result.
enum class GameEnd { over, interrupted, noPlayers, hangs, overLimit, serverGone };
/// "over", "interrupted", "no players", "hangs", "over the limit", "server gone".
const char* gameEndText(GameEnd end);

/// What came out of a game: a line of games.log.
struct GameResult {
  GameEnd end = GameEnd::over;
  std::string problem{};  ///< one line, empty if it is over
  std::string teamLeft{}, teamRight{};
  int scoreLeft = 0, scoreRight = 0;
  GameCounter counts{};
  double gameSeconds = 0, wallSeconds = 0;
};

struct GameWatchOptions {
  std::string host = "127.0.0.1";
  int port = simspark::standardMonitorPort;  ///< monitor port
  int players = 2 * teamSize;                ///< kick-off waits for so many
  double patience = 60;                      ///< so long; then with those who are there [s of real time]
  double settle = 2;       ///< before each kick-off, for robots to beam and rest [s of real time]
  double hang = 60;        ///< nothing changed for so long: it hangs [s of real time]
  double limit = 1e9;      ///< so long in all [s of real time]
  bool kickOff = true;     ///< false: the server does it by itself
  bool endServer = false;  ///< (killsim) at the end
  /// Called with every scene, in their order; may be empty.
  std::function<void(const simspark::SceneState&)> everyScene{};
  double endTime = 0;  ///< the game is over at this time of its clock [s]; 0: when the server says so
};

/// Sees a whole game through on any server with a monitor port: kicks off both halves (left, then right),
/// counts, and returns at its end. progress: called about once a second of real time with the scene.
GameResult watchGame(const GameWatchOptions& options, const StopSignal& stop,
                     const std::function<void(const simspark::SceneState&)>& progress);

/// What a line of games.log says beside the result.
struct GameLogEntry {
  std::string date{}, server{}, seed{}, nameLeft{}, nameRight{};  ///< names empty: those the teams have given
  double halfTime = 300;
};
extern const char* const gameLogHeader;
/// A line without its end; commas, quotes and line breaks in names become underscores.
std::string gameLogLine(const GameLogEntry& entry, const GameResult& result);
/// Appends a line, and the header if the file is new; several processes may do so at once. Throws
/// std::runtime_error, one line.
void appendGameLog(const std::string& file, const std::string& line);

}  // namespace plumbline::watch
