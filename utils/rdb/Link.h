#pragma once
#include <string>
#include <vector>

namespace plumbline::rdb {

/// A TCP connection that carries lines of text. No call waits longer than it says, and each ends at once when
/// the descriptor `stop` becomes readable.
class Link {
public:
  Link(std::string host, int port, std::string token, int stop);
  ~Link() { close(); }
  Link(const Link&) = delete;
  Link& operator=(const Link&) = delete;

  /// "" or why not, in one line.
  std::string connect(double seconds);
  bool connected() const { return fd_ >= 0; }
  void close();
  int descriptor() const { return fd_; }
  std::string name() const { return host_ + ':' + std::to_string(port_); }

  /// False: the connection is lost.
  bool send(const std::string& line);
  /// The lines that have come, waiting for the first at most so long; sees to connected().
  std::vector<std::string> receive(double seconds);

private:
  bool wait(short events, double seconds) const;

  std::string host_;
  int port_;
  std::string token_;
  int stop_, fd_ = -1;
  std::string in_;
};

}  // namespace plumbline::rdb
