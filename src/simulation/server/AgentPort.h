#pragma once
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "simspark/AgentCommand.h"
#include "simspark/StandardPorts.h"
#include "simulation/Simulation.h"
#include "simulation/server/Admission.h"
#include "simulation/server/LimitedLog.h"
#include "simulation/server/Sockets.h"

namespace plumbline::simulation {

/// The agents' connections: what they command goes into the simulation, its messages go to them. Commands are
/// kept until the start of the next cycle and carried out in the order of the players, so that the order of
/// arrival does not matter.
class AgentPort {
public:
  struct Config {
    std::string address = "127.0.0.1";
    int port = simspark::standardAgentPort;
    bool sync = false;                    ///< wait for (syn) of every agent
    double syncTimeout = 60;              ///< give up on a silent agent after so many seconds; 0: never
    double halfTimeout = 10;              ///< the same on half a message
    std::string token{};                  ///< if not empty, the first message must be (token TOKEN)
    double sceneTimeout = silentTimeout;  ///< an agent without a robot is dropped after this time [s]
  };

  AgentPort(const Config& config, Simulation& simulation, LogFunction log);

  int port() const { return listener_.port(); }
  void watch(std::vector<pollfd>& descriptors);
  /// events: those of the descriptors watch() appended.
  void serve(const pollfd* events);

  /// Agents that have a robot or have asked for one.
  int numAgents() const;
  /// Whether nobody has to be waited for; always so without sync.
  bool ready() const;
  /// Carries out what came since the last cycle.
  void carryOut();
  /// Sends everybody the senses of the last step.
  void sendSenses();
  /// The simulation restarted, with other ids: answers of agents to earlier messages are ignored.
  void restarted(const std::map<PlayerId, PlayerId>& ids);
  /// Closes connections whose clients went away, sent garbage, or kept everybody waiting.
  void dropBroken();

private:
  struct Agent {
    Agent(int fd, const std::string& address);
    FramedClient client;
    simspark::AgentCommandParser parser;
    std::vector<simspark::AgentCommand> pending;
    std::optional<PlayerId> player;
    bool admitted = false, sceneAsked = false;
    bool synced = false, everSynced = false;
    int cycles = 0;           ///< messages sent to it, as far as they count (unsyncedCycles)
    double waitingSince = 0;  ///< wall clock of the last message to it, or of its scene
    bool complained = false;
    bool answersPast = false;  ///< its next answer is to a message from before a restart
  };

  void accept();
  void receive(Agent& agent);
  void carryOut(Agent& agent, const simspark::AgentCommand& command);
  bool ready(const Agent& agent) const;
  std::string describe(const Agent& agent) const;
  void complain(Agent& agent, const std::string& problem);

  Config config_;
  Simulation& simulation_;
  LogFunction log_;
  Listener listener_;
  std::vector<std::unique_ptr<Agent>> agents_;
  std::size_t watched_ = 0;  ///< agents that watch() appended
};

}  // namespace plumbline::simulation
