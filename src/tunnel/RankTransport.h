#pragma once
#include <string>

namespace plumbline::tunnel {

/// How messages get from rank to rank: whole, and in the order in which one rank sent them to another. No
/// call waits. Each throws std::runtime_error, one line, for what makes going on impossible.
class RankTransport {
public:
  virtual ~RankTransport() = default;
  virtual int rank() const = 0;
  virtual int ranks() const = 0;
  /// At most maxFrame bytes.
  virtual void send(int to, std::string message) = 0;
  /// The next message that has come; false: none. Whoever sends calls it too: it is what moves messages.
  virtual bool receive(int& from, std::string& message) = 0;
  /// All that was sent is on its way.
  virtual bool sentAll() const = 0;
};

}  // namespace plumbline::tunnel
