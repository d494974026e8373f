#include "web/WebMonitor.h"

#include <filesystem>
#include <stdexcept>

#include "framework/ConfigFolder.h"
#include "simspark/ChildProcess.h"
#include "simspark/Loopback.h"
#include "web/ReplayFeed.h"

namespace plumbline::web {

namespace {

WebServer::Config complete(WebServer::Config config) {
  if (const std::string problem = bindProblem(config.address, config.token); !problem.empty())
    throw std::runtime_error(problem);
  if (config.folder.empty()) config.folder = builtPage();
  if (!std::filesystem::exists(config.folder + "/index.html"))
    throw std::runtime_error(config.folder + ": no page there; `make web` builds it into build/web");
  return config;
}

}  // namespace

std::string bindProblem(const std::string& address, const std::string& token) {
  if (simspark::isLoopbackAddress(address) || !token.empty()) return {};
  return "--bind " + address + " opens the page to others: set a --token";
}

std::string builtPage() {
  const std::string programs = programFolder();
  for (const char* folder : {"/../build/web", "/../../web"})
    if (std::filesystem::exists(programs + folder + "/index.html"))
      return std::filesystem::canonical(programs + folder).string();
  throw std::runtime_error("the page is not built: run `make web` once");
}

WebMonitor::WebMonitor(const WebMonitorConfig& config) : server(complete(config.server), broadcast) {
  if (config.replay.empty()) {
    auto live = std::make_unique<LiveFeed>(config.live, broadcast);
    drawingPort_ = live->drawingPort();
    drawingProblem_ = live->drawingProblem();
    feed = std::move(live);
  } else {
    feed = std::make_unique<ReplayFeed>(config.replay, broadcast);
  }
  const bool loopback = simspark::isLoopbackAddress(config.server.address);
  address_ = "http://" + (loopback ? "localhost" : config.server.address) + ':' +
             std::to_string(server.port()) + '/';
  if (!config.server.token.empty()) address_ += "?token=" + config.server.token;
  server.start(*feed);
}

WebMonitor::~WebMonitor() { server.stop(); }

}  // namespace plumbline::web
