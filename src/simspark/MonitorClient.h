#pragma once
#include <optional>
#include <string>

#include "simspark/Connection.h"
#include "simspark/SceneState.h"
#include "simspark/TrainerCommand.h"

namespace plumbline::simspark {

/// A monitor and trainer: follows the scene and sends commands. The other end is this project's simulator or
/// the league's server.
class MonitorClient {
public:
  /// Empty on success, else one line why not. token: what a simulator open to others asks for.
  std::string connect(const std::string& host, int port, const std::string& token = "",
                      double timeoutSeconds = 5);
  /// See Connection.
  void interruptBy(int stopDescriptor) { connection_.interruptBy(stopDescriptor); }
  bool connected() const { return connection_.connected(); }
  void close() { connection_.close(); }

  bool send(const TrainerCommand& command) { return connection_.send(writeTrainerCommand(command)); }
  /// A command as text, for what has no type here.
  bool send(const std::string& command) { return connection_.send(command); }

  /// Waits for the next message and takes it into scene(). timeout: nothing came; closed: see error(). A
  /// message that cannot be read closes the connection.
  Connection::Status receive(double timeoutSeconds = -1);
  /// Takes in all that has come, without waiting. False if the connection is gone.
  bool poll();
  const SceneState& scene() const { return state_; }
  /// Of the embedded simulator, once it has answered a ClockCommand; other servers never do.
  const std::optional<SimulatorClock>& clock() const { return clock_; }
  const std::string& error() const { return problem_.empty() ? connection_.error() : problem_; }

private:
  Connection connection_;
  SceneState state_;
  std::optional<SimulatorClock> clock_;
  std::string problem_;
};

}  // namespace plumbline::simspark
