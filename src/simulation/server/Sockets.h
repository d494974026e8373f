#pragma once
#include <poll.h>

#include <string>
#include <string_view>
#include <vector>

#include "framework/SteadyClock.h"
#include "simspark/Framing.h"

namespace plumbline::simulation {

/// A listening TCP socket.
class Listener {
public:
  /// An address as a number, or localhost; port 0: a free one. Throws std::runtime_error, one line, if it
  /// cannot be had.
  Listener(const std::string& address, int port);
  ~Listener();
  Listener(const Listener&) = delete;
  Listener& operator=(const Listener&) = delete;

  int port() const { return port_; }
  int descriptor() const { return fd_; }
  /// A new client's socket, non-blocking, and its address; -1: none waits.
  int accept(std::string& address);

private:
  int fd_ = -1;
  int port_ = 0;
};

/// The server's end of a client's connection. Never blocks: what the client does not take is queued up to a
/// limit. Once broken it stays so, with the reason, until its owner drops it.
class FramedClient {
public:
  FramedClient(int fd, std::string address, std::size_t maxMessage, std::size_t maxQueue);
  ~FramedClient();
  FramedClient(const FramedClient&) = delete;
  FramedClient& operator=(const FramedClient&) = delete;

  /// What to wait for.
  pollfd watch() const;
  /// Reads and writes what the events allow.
  void serve(short events);
  /// The next message; valid until the next serve().
  bool next(std::string_view& message);
  void send(std::string_view text);

  void drop(const std::string& why);
  bool idle() const { return queue_.empty(); }  ///< it has taken all that was sent
  bool broken() const { return !reason_.empty(); }
  const std::string& reason() const { return reason_; }
  const std::string& address() const { return address_; }
  double since() const { return connectedSince_; }  ///< wall clock
  /// Since when a message has been half received; 0: none is.
  double halfSince() const { return halfMessageSince_; }

private:
  void read();
  void flush();

  int fd_;
  std::string address_;
  simspark::FrameReader reader_;
  std::size_t maxMessage_, maxQueue_;
  std::string queue_;
  std::string reason_;
  double halfMessageSince_ = 0;
  const double connectedSince_ = steadySeconds();
};

}  // namespace plumbline::simulation
