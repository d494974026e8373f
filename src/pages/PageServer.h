#pragma once
#include <memory>
#include <string>

#include "pages/PageSource.h"

namespace plumbline::pages {

/// Serves a folder of files over HTTP and, as WebSocket protocol "plumbline", what a source has for each
/// page. One thread. A page of another site cannot connect: its origin must be this server, and without a
/// token the server must be addressed as the loopback interface.
class PageServer {
public:
  struct Config {
    std::string address = "127.0.0.1";
    int port = 8080;       ///< 0: a free one
    bool anyPort = false;  ///< a free one if that is in use
    std::string folder{};  ///< of the page
    std::string token{};   ///< if not empty, a page is opened with ?token=TOKEN
    std::string index = "index.html";
  };
  /// Listens; throws std::runtime_error, one line, if the port cannot be had.
  PageServer(const Config& config, PageSource& source);
  ~PageServer();
  PageServer(const PageServer&) = delete;
  PageServer& operator=(const PageServer&) = delete;

  /// Serves from now on until stop().
  void start();
  void stop();
  int port() const;

private:
  struct Implementation;
  std::unique_ptr<Implementation> implementation_;
};

}  // namespace plumbline::pages
