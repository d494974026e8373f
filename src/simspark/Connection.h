#pragma once
#include <string>
#include <string_view>

#include "simspark/Framing.h"

namespace plumbline::simspark {

/// A client's TCP connection that carries framed messages: to the agent port or the monitor port. Not shared
/// between threads. After any failure it is closed, and connecting anew is the caller's decision. No call
/// outlasts its time limit, and each ends at once when the descriptor of interruptBy() becomes readable.
class Connection {
public:
  enum class Status { message, timeout, closed };

  Connection() = default;
  ~Connection() { close(); }
  Connection(Connection&& other) noexcept;
  Connection& operator=(Connection&& other) noexcept;

  /// Empty on success, else one line why not ("cannot connect to localhost:3100: Connection refused").
  std::string connect(const std::string& host, int port, double timeoutSeconds = 5);
  bool connected() const { return fd_ >= 0; }
  /// What ends every wait, e.g. StopSignal::fileDescriptor(); -1: nothing. It is only looked at. Then connect
  /// fails, send closes the connection and receive reports a timeout.
  void interruptBy(int descriptor) { stopDescriptor_ = descriptor; }
  /// For a client that does not answer each message, as a monitor: what comes is acknowledged at once, also
  /// after something was sent.
  void listensOnly() { answers_ = Answers::never; }
  int descriptor() const { return fd_; }  ///< to wait for together with others; -1: not connected
  void close();

  /// Waits for the next message; it stays valid until the next call. timeoutSeconds < 0: as long as it takes,
  /// 0: only what is there. closed: the other side went away or sent a length beyond maxServerMessage;
  /// error() says which.
  Status receive(std::string_view& message, double timeoutSeconds = -1);
  /// False if the connection broke; error() says why. Waits while the other side does not read; one that does
  /// not for so long is given up.
  bool send(std::string_view text, double timeoutSeconds = 10);
  const std::string& error() const { return lastError_; }

private:
  /// Whether what came is answered, which acknowledges it. yes: something was sent since the last bytes came.
  enum class Answers { no, yes, never };

  Status fail(const std::string& why);

  int fd_ = -1, stopDescriptor_ = -1;
  Answers answers_ = Answers::no;
  FrameReader reader_{maxServerMessage};
  std::string outgoing_, lastError_;
};

}  // namespace plumbline::simspark
