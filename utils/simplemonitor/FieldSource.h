#pragma once
#include <string>
#include <vector>

#include "simspark/Connection.h"
#include "simspark/FieldScene.h"

namespace plumbline::simplemonitor {

/// Where the state of the game comes from: the simulator's compact port or any SimSpark monitor port. Which
/// of them it is shows in the first message.
class FieldSource {
public:
  /// The first of the ports that answers is taken. token: what a simulator open to others asks for.
  FieldSource(std::string host, std::vector<int> ports, std::string token);

  /// Empty, or one line why none of the ports could be had.
  std::string connect();
  /// Ends waits when it becomes readable.
  void interruptBy(int stopDescriptor) { connection_.interruptBy(stopDescriptor); }
  bool connected() const { return connection_.connected(); }
  /// Readable when something came; -1: not connected.
  int descriptor() const { return connection_.descriptor(); }
  /// Takes in what has come; waits so long for the first of it [s]. True if the state is new.
  bool receive(double timeoutSeconds);

  const simspark::FieldState& state() const { return state_; }
  bool complete() const { return complete_; }  ///< a state has come over this connection
  /// Why there is no connection any more, one line.
  const std::string& problem() const { return problem_; }
  std::string name() const { return host_ + ':' + std::to_string(port_); }
  std::size_t bytes() const { return bytes_; }  ///< received since the beginning

private:
  bool take(std::string_view message);
  void lose(const std::string& why);

  std::string host_, token_;
  std::vector<int> ports_;
  int port_ = 0;
  simspark::Connection connection_;
  simspark::FieldScene scene_;  ///< of a SimSpark monitor port
  simspark::FieldState state_;
  bool complete_ = false;
  std::string problem_;
  std::size_t bytes_ = 0;
};

}  // namespace plumbline::simplemonitor
