#pragma once
#include "framework/Representation.h"

namespace plumbline {

/// State of the connection to the simulator.
REPRESENTATION(SimSparkInfo)
class SimSparkInfo : public SimSparkInfoBase {
public:
  bool connected = false;
  int connections = 0;  ///< how often the agent has connected; > 1 after a restart of the simulator
  int agentPort = 0;
  int monitorPort = 0;
  unsigned cycles = 0;  ///< messages received since the last connect
  void stream(InStream* in, OutStream* out) override {
    STREAM(connected);
    STREAM(connections);
    STREAM(agentPort);
    STREAM(monitorPort);
    STREAM(cycles);
  }
};

}  // namespace plumbline
