#pragma once
#include <memory>
#include <string>

#include "web/Broadcast.h"
#include "web/Feed.h"

namespace plumbline::web {

/// Serves a folder of files over HTTP and, as WebSocket protocol "plumbline", what a Broadcast holds; what
/// pages send goes to the feed. One thread. A page of another site cannot connect: its origin must be this
/// server, and without a token the server must be addressed as the loopback interface.
class WebServer {
public:
  struct Config {
    std::string address = "127.0.0.1";
    int port = 8080;       ///< 0: a free one
    bool anyPort = false;  ///< a free one if that is in use
    std::string folder;    ///< of index.html
    std::string token{};   ///< if not empty, a page is opened with ?token=TOKEN
  };
  /// Listens; throws std::runtime_error, one line, if the port cannot be had.
  WebServer(const Config& config, Broadcast& broadcast);
  ~WebServer();
  WebServer(const WebServer&) = delete;
  WebServer& operator=(const WebServer&) = delete;

  /// Serves from now on until stop().
  void start(Feed& feed);
  void stop();
  int port() const;

private:
  struct Implementation;
  std::unique_ptr<Implementation> implementation;
};

}  // namespace plumbline::web
