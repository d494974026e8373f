#pragma once
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "simspark/StandardPorts.h"
#include "simspark/TrainerCommand.h"
#include "simulation/Simulation.h"
#include "simulation/monitor/MonitorScene.h"
#include "simulation/server/AgentPort.h"
#include "simulation/server/Sockets.h"

namespace plumbline::simulation {

/// How fast the server lets time pass; trainers change it.
struct RunClock : simspark::SimulatorClock {
  int steps = 0;              ///< cycles to be done though it is paused
  std::uint64_t changes = 1;  ///< grows with every change that is sent to trainers
  bool stopped() const { return paused && steps == 0; }
};

/// Monitors and trainers: they get the scene and may command the simulation.
class MonitorPort {
public:
  struct Config {
    std::string address = "127.0.0.1";
    int port = simspark::standardMonitorPort;
    int interval = 2;                     ///< cycles between two messages
    std::string token;                    ///< if not empty, the first message must be (token TOKEN)
    double halfTimeout = 10;              ///< give up on half a message after so many seconds
    double tokenTimeout = silentTimeout;  ///< the same on the token
    std::size_t maxQueue = 4 << 20;  ///< bytes a monitor may leave unread: nearly a minute of a full game
  };

  MonitorPort(const Config& config, Simulation& simulation, LogFunction log);

  int port() const { return listener_.port(); }
  void watch(std::vector<pollfd>& descriptors);
  void serve(const pollfd* events);

  /// Carries out the trainers' commands. True if there were any.
  bool carryOut();
  /// Sends new monitors the whole scene, and, if a message is due, the others the changes.
  void sendState(bool regular);
  bool due() const { return simulation_.cycle() % static_cast<std::uint64_t>(config_.interval) == 0; }
  /// Whether a client has not been sent yet that robots came or left.
  bool owe() const;
  void dropBroken();
  bool killRequested() const { return killed_; }
  /// The last wish for everything from the start since the last call.
  std::optional<simspark::ResetCommand> takeReset() { return std::exchange(reset_, std::nullopt); }
  RunClock& clock() { return clock_; }
  const RunClock& clock() const { return clock_; }

private:
  struct Monitor {
    Monitor(int fd, const std::string& address, std::size_t maxQueue);
    FramedClient client;
    simspark::TrainerCommandParser parser;
    std::unique_ptr<MonitorScene> view;  ///< of one that only looks: what it was sent
    double interval = 0, nextView = 0;   ///< [s], and wall clock
    bool viewStale = true;
    std::uint64_t viewVersion = 0;  ///< of the scene it was sent
    bool clockAsked = false;
    std::uint64_t clockSent = 0;
    std::size_t pending = 0;  ///< commands of this cycle
    bool spoke = false;       ///< said anything, so that it is no idle connection
    bool admitted = false, informed = false, acknowledge = false, complained = false;
  };

  /// Those that have a scene, those that have none yet, or both.
  enum class Recipients { informed, uninformed, all };

  void accept();
  void send(const std::string& text, Recipients recipients);
  void receive(Monitor& monitor);
  bool admits(Monitor& monitor, std::string_view text);
  void carryOut(Monitor& monitor, const simspark::TrainerCommand& command);
  void carryOut(Monitor& monitor, const simspark::ClockCommand& command);
  void carryOut(Monitor& monitor, const simspark::ViewerCommand& command);
  void sendToViewer(Monitor& monitor, bool regular);

  Config config_;
  Simulation& simulation_;
  LogFunction log_;
  Listener listener_;
  MonitorScene scene_;
  std::vector<std::unique_ptr<Monitor>> monitors_;
  std::vector<std::pair<Monitor*, simspark::TrainerCommand>> pending_;
  std::size_t watched_ = 0;
  std::uint64_t sentVersion_ = 0;
  bool killed_ = false;
  std::optional<simspark::ResetCommand> reset_;
  RunClock clock_;
};

}  // namespace plumbline::simulation
