#pragma once
#include <functional>
#include <string>
#include <vector>

#include "simspark/StandardPorts.h"

namespace plumbline {

/// What the command line of the SimSpark agent says; a module reaches it through object<AgentOptions>().
struct AgentOptions {
  std::string team = "Plumbline";
  int number = 1;     ///< uniform number 1..11, or 0: the next free one
  std::string token;  ///< token of a server that is open to other machines; empty: none
  int type = 0;       ///< robot type, 0 to numSimsparkTypes() - 1
  std::string host = "127.0.0.1";
  int port = simspark::standardAgentPort;           ///< agent port
  int monitorPort = simspark::standardMonitorPort;  ///< trainer commands go there
  bool startSimulator = false;  ///< start a simulator of its own on free ports instead of connecting to host
  std::vector<std::string> simulatorOptions;  ///< passed to that simulator
  /// Called with a line that says what the agent waits for; may be empty.
  std::function<void(const std::string&)> notify;
};

}  // namespace plumbline
