#pragma once
#include <memory>
#include <string>
#include <vector>

#include "simspark/StandardPorts.h"
#include "simulation/Simulation.h"
#include "simulation/server/AgentPort.h"
#include "simulation/server/Sockets.h"

namespace plumbline::simulation {

/// The port of bin/simplemonitor (thesis A.6.3): sends everybody who connects where robots and ball are, at
/// most five times a second of real time, at most 4 kB/s with 22 robots (simspark/FieldMessage.h). It takes
/// no commands.
class FieldPort {
public:
  struct Config {
    std::string address = "127.0.0.1";
    int port = simspark::standardFieldPort;
    std::string token{};  ///< if not empty, the first message must be (token TOKEN)
  };

  /// Errors: std::runtime_error, one line, if the port cannot be had.
  FieldPort(const Config& config, Simulation& simulation, LogFunction log);

  int port() const { return listener_.port(); }
  void watch(std::vector<pollfd>& descriptors);
  void serve(const pollfd* events);
  /// Sends the changes since the last message to those whose turn it is.
  void sendState();
  void dropBroken();

private:
  struct Viewer {
    Viewer(int fd, const std::string& address);
    FramedClient client;
    bool admitted = false, spoke = false;
    double nextTime = 0;  ///< wall clock
    std::string lastMessage;
  };

  void accept();
  void receive(Viewer& viewer);
  const std::string& message();

  Config config_;
  Simulation& simulation_;
  LogFunction log_;
  Listener listener_;
  std::vector<std::unique_ptr<Viewer>> viewers_;
  std::size_t watched_ = 0;
  std::string text_;
};

/// The state of a game as the port sends it.
std::string fieldMessage(const Simulation& simulation);

}  // namespace plumbline::simulation
