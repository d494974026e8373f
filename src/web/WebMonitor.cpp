#include "web/WebMonitor.h"

#include "pages/PagePlace.h"
#include "web/ReplayFeed.h"

namespace plumbline::web {

WebMonitor::WebMonitor(const WebMonitorConfig& config)
    : server(pages::completed(config.server, {"--bind", "--token"}), broadcast) {
  if (config.replay.empty()) {
    auto live = std::make_unique<LiveFeed>(config.live, broadcast);
    drawingPort_ = live->drawingPort();
    drawingProblem_ = live->drawingProblem();
    feed = std::move(live);
  } else {
    feed = std::make_unique<ReplayFeed>(config.replay, broadcast);
  }
  address_ = pages::addressOf(config.server, server.port());
  server.start(*feed);
}

WebMonitor::~WebMonitor() { server.stop(); }

}  // namespace plumbline::web
