#pragma once
#include <atomic>
#include <mutex>
#include <optional>
#include <string>
#include <thread>

#include "web/DrawingSets.h"

namespace plumbline::web {

/// Receives the agents' drawings: RoboViz's datagrams on a UDP port of the loopback interface. Other
/// datagrams are dropped.
class DrawingPort {
public:
  /// port 0: a free one. Throws std::runtime_error, one line, if it cannot be had.
  explicit DrawingPort(int port);
  ~DrawingPort();
  DrawingPort(const DrawingPort&) = delete;
  DrawingPort& operator=(const DrawingPort&) = delete;

  int port() const { return port_; }
  /// What is shown, as DrawingSets::toJson, if it changed since the last call.
  std::optional<std::string> takeChanges();

private:
  void run();

  int fd_ = -1, port_ = 0;
  std::mutex mutex_;
  DrawingSets sets_;
  bool changed_ = false;
  std::atomic<bool> stop_ = false;
  std::thread thread_;
};

}  // namespace plumbline::web
