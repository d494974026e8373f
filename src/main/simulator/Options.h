#pragma once
#include <optional>
#include <string>

#include "simulation/server/Server.h"

namespace plumbline::simulation {

/// The options of bin/simulator.
struct Options {
  ServerConfig server;
  std::string portsFile, statisticsFile;
  std::string replayFile;          ///< a recording to repeat instead of serving
  std::optional<int> webPort;      ///< of the page that shows the game; none: no page
  bool anyWebPort = false;         ///< a free one if that is in use
  std::optional<int> drawingPort;  ///< UDP, of the agents' drawings; none: the standard one, if it is free
  std::string recordFile;          ///< where the page's match is recorded; empty: nowhere
  std::optional<int> replayType;   ///< robot of the recording, if its name does not say it
  bool verbose = false, dieWithParent = false;
  std::optional<int> exitStatus;  ///< the command line is done with: help was printed, or what is wrong
};

/// Throws std::runtime_error, one line, for options that do not go together.
Options parseOptions(int argc, char** argv);

}  // namespace plumbline::simulation
