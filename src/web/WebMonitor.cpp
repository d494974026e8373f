#include "web/WebMonitor.h"

#include "pages/PagePlace.h"
#include "web/ReplayFeed.h"

namespace plumbline::web {

WebMonitor::WebMonitor(const WebMonitorConfig& config)
    : server_(pages::completed(config.server, {"--bind", "--token"}), broadcast_) {
  if (config.replay.empty()) {
    auto live = std::make_unique<LiveFeed>(config.live, broadcast_);
    drawingPort_ = live->drawingPort();
    drawingProblem_ = live->drawingProblem();
    feed_ = std::move(live);
  } else {
    feed_ = std::make_unique<ReplayFeed>(config.replay, broadcast_);
  }
  address_ = pages::addressOf(config.server, server_.port());
  server_.start(*feed_);
}

WebMonitor::~WebMonitor() { server_.stop(); }

}  // namespace plumbline::web
