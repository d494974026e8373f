#pragma once
#include <string>
#include <vector>

#include "game/RunLines.h"
#include "game/Summary.h"
#include "game/TrackPicture.h"
#include "simspark/SceneState.h"
#include "simspark/StandardPorts.h"

namespace plumbline {
class StopSignal;
}

namespace plumbline::game {

struct GameOptions {
  int type = 0;  ///< of the robot, as simsparkRobots
  unsigned seed = 1;
  double limit = 300;          ///< simulated [s]
  bool web = false;            ///< the simulator shows the game on a page
  bool stay = false;           ///< after the end the game is paused on the page until the stop is requested
  bool realtime = false;       ///< 50 cycles a second instead of as fast as it goes
  std::string engine = "ode";  ///< physics of the embedded simulator
  std::string output;          ///< folder
  std::string host;            ///< of a server that runs already; empty: an embedded simulator is started
  int port = simspark::standardAgentPort, monitorPort = simspark::standardMonitorPort;
  std::string field;  ///< file with the sizes of the field; empty: the configuration's
  std::vector<std::string> agentOptions, simulatorOptions;
};

/// One robot alone on the field until it scores: what `make run` does. Starts simulator and agent (programs
/// beside this one), kicks off, and prints a line per second of the game. Writes summary.json, track.svg,
/// track.csv (robot and ball ten times a second, metres and radians) and the programs' logs to the output
/// folder.
class GameRun {
public:
  explicit GameRun(GameOptions options) : options_(std::move(options)) {}

  /// Plays; returns when a goal was scored, the time is up, or the stop was requested. Nothing it started is
  /// left running. Throws std::runtime_error if a program could not be started or died (naming its log),
  /// or the folder cannot be written.
  Summary play(StopSignal& stop);

private:
  class Session;

  void watch(const simspark::SceneState& scene);
  void stay(Session& session, StopSignal& stop) const;
  void countFalls(const simspark::SceneRobot& robot, double time);

  GameOptions options_;
  Summary summary_;
  std::vector<TrackPoint> track_;
  std::string table_ = "time,x,y,heading,up,ball_x,ball_y,ball_z,mode\n";  ///< of track.csv
  RunLines lines_;
  double nextLine_ = 0;
  bool stood_ = false;  // has been upright since it came onto the field
  bool fallen_ = false;
};

}  // namespace plumbline::game
