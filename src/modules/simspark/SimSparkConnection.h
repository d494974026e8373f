#pragma once
#include "framework/Module.h"
#include "modules/simspark/AgentOptions.h"
#include "modules/simspark/SimSparkLink.h"
#include "representations/infrastructure/ServerMessageText.h"
#include "representations/infrastructure/SimSparkInfo.h"

namespace plumbline {

MODULE(SimSparkConnection)
PROVIDES(ServerMessageText)
PROVIDES(SimSparkInfo)
END_MODULE

/// Receives one message of the simulator per cycle and thereby sets the agent's pace. Connects, asks for the
/// robot and its place in the team, connects again when the simulator went away, and can start a simulator of
/// its own on free ports and restart it when it dies.
class SimSparkConnection : public SimSparkConnectionBase {
public:
  void init() override;
  void execute() override;
  void update(ServerMessageText* theServerMessageText) override;
  void update(SimSparkInfo* theSimSparkInfo) override;

private:
  bool connect();
  bool tryConnect(std::string& why);
  bool receive();

  const AgentOptions* options_ = nullptr;
  SimSparkLink* link_ = nullptr;
  std::string simulatorProgram_;  ///< path, relative to the agent's own folder
  double connectSeconds_ = 0;     ///< how long a connect is tried [s]
  bool reconnect_ = true;
  int maxRestarts_ = 0;
  int restarts_ = 0;
  int connections_ = 0;
  unsigned cycles_ = 0;
  std::string message_;
};

}  // namespace plumbline
