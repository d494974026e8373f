#pragma once
#include <cstddef>
#include <string>
#include <string_view>

namespace plumbline::farm {

/// A listening TCP socket. Throws std::runtime_error, one line, if the address or the port cannot be had.
int listenOn(const std::string& address, int port, int& portHad);
/// A connected one, which does not block. Waits 10 s at most, or until `stopDescriptor` is readable (-1:
/// none). Throws std::runtime_error "cannot reach HOST:PORT: REASON".
int connectTo(const std::string& host, int port, int stopDescriptor = -1);

/// Lines of text over a socket, which it closes. Never blocks; what waits in either direction is bounded.
class LineSocket {
public:
  LineSocket(int fd, std::size_t maxLine, std::size_t maxWaiting);
  ~LineSocket();
  LineSocket(LineSocket&& other) noexcept;
  LineSocket(const LineSocket&) = delete;
  LineSocket& operator=(const LineSocket&) = delete;

  int descriptor() const { return fd_; }
  /// Events for poll().
  short events() const { return static_cast<short>(out_.empty() ? 1 : 1 | 4); }  // POLLIN, POLLOUT
  /// Takes what has come and sends what can go.
  void serve(short events);
  /// Waits until something has come, at most so long [s], or until `stopDescriptor` is readable; false:
  /// nothing.
  bool wait(double seconds, int stopDescriptor = -1);
  /// The next line without its end; false: there is none yet.
  bool next(std::string& line);
  void send(std::string_view line);
  bool sentAll() const { return out_.empty(); }

  bool broken() const { return !reason_.empty(); }
  const std::string& reason() const { return reason_; }

private:
  void receive();
  void flush();
  void fail(const std::string& reason);

  int fd_;
  std::size_t maxLine_, maxWaiting_;
  std::string in_, out_, reason_;
};

}  // namespace plumbline::farm
