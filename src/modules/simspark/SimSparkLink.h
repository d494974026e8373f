#pragma once
#include <memory>
#include <string>

#include "simspark/AgentCommand.h"
#include "simspark/Connection.h"
#include "simspark/SimulatorProcess.h"

namespace plumbline {

/// The agent's connection to the simulator, shared by the modules that read from it and write to it; made
/// when the first of them asks.
class SimSparkLink {
public:
  simspark::Connection connection;
  std::unique_ptr<simspark::SimulatorProcess> simulator;  ///< when the agent has started its own
  simspark::Ports ports;                                  ///< in use now

  /// Sends one message to the server; errors show at the next receive.
  void send(const simspark::AgentCommand& command);

private:
  std::string text_;
};

}  // namespace plumbline
