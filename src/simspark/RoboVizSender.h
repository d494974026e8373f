#pragma once
#include <netinet/in.h>

#include <string>
#include <vector>

namespace plumbline::simspark {

/// Sends datagrams to a viewer and never waits: if the system has no room, they are lost.
class RoboVizSender {
public:
  static constexpr int standardPort = 32769;

  /// An IPv4 address in digits. Throws std::runtime_error, one line, if it is none.
  RoboVizSender(const std::string& address, int port);
  ~RoboVizSender();
  RoboVizSender(const RoboVizSender&) = delete;
  RoboVizSender& operator=(const RoboVizSender&) = delete;

  void send(const std::vector<std::string>& datagrams) const;

private:
  int fd_ = -1;
  sockaddr_in to_{};
};

}  // namespace plumbline::simspark
