#pragma once
#include "pages/PageServer.h"
#include "web/BroadcastPages.h"

namespace plumbline::web {

/// Serves a page and what a Broadcast holds; what pages send goes to the feed.
class WebServer {
public:
  using Config = pages::PageServer::Config;
  /// Listens; throws std::runtime_error, one line, if the port cannot be had.
  WebServer(const Config& config, Broadcast& broadcast) : pages_(broadcast), server_(config, pages_) {}

  /// Serves from now on until stop().
  void start(Feed& feed) {
    pages_.setFeed(feed);
    server_.start();
  }
  void stop() { server_.stop(); }
  int port() const { return server_.port(); }

private:
  BroadcastPages pages_;
  pages::PageServer server_;
};

}  // namespace plumbline::web
