#pragma once
#include <memory>
#include <optional>
#include <string>

#include "web/LiveFeed.h"
#include "web/WebServer.h"

namespace plumbline::web {

struct WebMonitorConfig {
  WebServer::Config server;  ///< folder empty: where the build puts the page
  LiveFeed::Config live;
  std::string replay{};  ///< a match file to show instead of a running game
};

/// The page with a game on it: everything bin/webmonitor does, in threads of its own until it is destroyed.
class WebMonitor {
public:
  /// Throws std::runtime_error, one line, for what cannot be had.
  explicit WebMonitor(const WebMonitorConfig& config);
  ~WebMonitor();
  WebMonitor(const WebMonitor&) = delete;
  WebMonitor& operator=(const WebMonitor&) = delete;

  /// "http://localhost:8080/", with the token if there is one.
  const std::string& address() const { return address_; }
  int port() const { return server_.port(); }
  /// UDP port of the agents' drawings; -1: none.
  int drawingPort() const { return drawingPort_; }
  /// Why it goes without drawings, one line; empty: it has them, or nobody asked for them.
  const std::string& drawingProblem() const { return drawingProblem_; }

private:
  Broadcast broadcast_;
  WebServer server_;
  std::unique_ptr<Feed> feed_;
  std::string address_, drawingProblem_;
  int drawingPort_ = -1;
};

}  // namespace plumbline::web
