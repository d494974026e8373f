#pragma once
#include <atomic>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "simulation/Simulation.h"
#include "simulation/server/AgentPort.h"
#include "simulation/server/FieldPort.h"
#include "simulation/server/MonitorPort.h"

namespace plumbline::simulation {

struct ServerConfig {
  SimulationConfig simulation;
  AgentPort::Config agents;
  MonitorPort::Config monitors;
  std::optional<FieldPort::Config> field;  ///< where bin/simplemonitor looks; none: no such port
  bool fieldOptional = false;              ///< do without if its port is in use
  bool realTime = true;
  /// The clock is stopped until this many agents have connected, and later while none is connected; 0: it is
  /// never stopped.
  int waitForAgents = 0;
  std::optional<double> maxSeconds;  ///< of simulated time, then run() returns
};

/// Time that a run took.
struct ServerStatistics {
  std::uint64_t cycles = 0;
  double simulatedSeconds = 0, wallSeconds = 0;
  double cpuSeconds = 0;  ///< of this process
};

/// The simulator as a server on two ports, in one thread. A cycle, in the order of the league's server: read
/// and carry out actions, send the senses made at the end of the previous cycle, physics, wait for the clock,
/// make senses.
class Server {
public:
  /// Opens both ports; throws std::runtime_error, one line, if one cannot be had.
  Server(const ServerConfig& config, const LogFunction& log);

  int agentPort() const { return agents_.port(); }
  int monitorPort() const { return monitors_.port(); }
  int fieldPort() const { return field_ ? field_->port() : 0; }  ///< 0: there is none
  /// Runs until stop is set (a signal handler may do it), a trainer kills the simulator, or the time is over.
  void run(const std::atomic<bool>& stop);
  const ServerStatistics& statistics() const { return statistics_; }
  Simulation& simulation() { return simulation_; }

private:
  /// Reads and accepts what is there, waiting for something for at most so long.
  void listen(int milliseconds);
  /// Reads until everybody who has to be waited for is ready; false if it should be tried again.
  bool collect();
  bool clockIsStopped() const;
  /// Carries out what trainers want; true if they wanted anything.
  bool obeyTrainers();
  void cycle();
  void openField();
  void sendField();
  void waitForClock();

  /// Prints why nothing moves, after some time without motion.
  void reportWait();

  ServerConfig config_;
  LimitedLog log_;
  Simulation simulation_;
  AgentPort agents_;
  MonitorPort monitors_;
  std::optional<FieldPort> field_;
  std::vector<pollfd> descriptors_;
  bool stood_ = false;  ///< the clock, when it was looked at last
  bool started_ = false;
  double nextTick_ = 0;      ///< wall clock
  double waitReported_ = 0;  ///< wall clock of the last line about waiting, or of the beginning of the wait
  int agentsReported_ = -1;  ///< how many were there then; -1: this wait is not reported yet
  double logLooked_ = 0;     ///< wall clock
  ServerStatistics statistics_;
};

}  // namespace plumbline::simulation
