#pragma once
#include "framework/Module.h"
#include "modules/simspark/AgentOptions.h"
#include "modules/simspark/SimSparkLink.h"
#include "representations/infrastructure/ServerMessageText.h"
#include "representations/infrastructure/SimSparkInfo.h"

namespace plumbline {

class Monitor;

MODULE(SimSparkConnection)
  PROVIDES(ServerMessageText)
  PROVIDES(SimSparkInfo)
  PARAMETER(std::string, simulator, "simulator", "", Range(),
            "program started with --start-simulator, relative to the folder of the agent")
  PARAMETER(double, connectSeconds, 0, "s", Range(0, 3600),
            "time after which the agent gives up to connect; 0: never")
  PARAMETER(bool, reconnect, true, "", Range(), "connects again when the simulator went away")
  PARAMETER(int, maxRestarts, 100, "", Range(0, 1e9), "restarts of a simulator that the agent has started")
END_MODULE

/// Receives one message of the simulator per cycle and so sets the agent's rate. Connects, requests the robot
/// and its place in the team, and connects again after a disconnection. It can start its own simulator on
/// free ports and restart it when it dies. It waits without a limit, says for what (AgentOptions::notify),
/// and stops at once when the agent ends.
class SimSparkConnection : public SimSparkConnectionBase {
public:
  void init() override;
  void execute() override;
  void update(ServerMessageText* theServerMessageText) override;
  void update(SimSparkInfo* theSimSparkInfo) override;

private:
  /// What the server owes us.
  enum class Phase { scene, place, play };

  bool connect();
  bool startSimulator();
  void askForRobot();
  void askForPlace();
  bool receive();
  void answered();
  void lookForPlace(std::string_view text);
  void reportWait(double seconds);
  void lost();
  void notify(const std::string& line);
  void pause(double seconds) const;

  const AgentOptions* options_ = nullptr;
  SimSparkLink* link_ = nullptr;
  Monitor* monitor_ = nullptr;
  std::string simulatorProgram_;  ///< path, relative to the agent's own folder
  Phase phase_ = Phase::scene;
  double phaseSince_ = 0,
         placeAsked_ = 0;  ///< wall clock: when to say what is waited for decides nothing else
  int placeRequests_ = 0;
  bool attached_ = false;       ///< what was reported last: connected
  bool placed_ = false;         ///< the server has given a number
  bool phaseReported_ = false;  ///< what this phase waits for has been reported
  bool waitReported_ = false;   ///< a wait was reported since the last message; then its end is, too
  bool wasHere_ = false;        ///< a server has been lost
  int restarts_ = 0;
  int connections_ = 0;
  unsigned cycles_ = 0;
  std::string message_;
};

}  // namespace plumbline
