#include "web/WebMonitor.h"

#include <filesystem>
#include <stdexcept>

#include "simspark/ChildProcess.h"
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

bool isLoopback(const std::string& address) { return address == "localhost" || address.starts_with("127."); }

}  // namespace

std::string bindProblem(const std::string& address, const std::string& token) {
  if (isLoopback(address) || !token.empty()) return {};
  return "--bind " + address + " opens the page to others: set a --token";
}

std::string builtPage() {
  const std::string programs = simspark::programFolder();
  for (const char* folder : {"/../build/web", "/../../web"})
    if (std::filesystem::exists(programs + folder + "/index.html"))
      return std::filesystem::canonical(programs + folder).string();
  throw std::runtime_error("the page is not built: run `make web` once");
}

WebMonitor::WebMonitor(const WebMonitorConfig& config) : server(complete(config.server), broadcast) {
  if (config.replay.empty()) {
    auto live = std::make_unique<LiveFeed>(config.live, broadcast);
    drawingPort_ = live->drawingPort();
    feed = std::move(live);
  } else {
    feed = std::make_unique<ReplayFeed>(config.replay, broadcast);
  }
  const bool loopback = isLoopback(config.server.address);
  address_ = "http://" + (loopback ? "localhost" : config.server.address) + ':' +
             std::to_string(server.port()) + '/';
  if (!config.server.token.empty()) address_ += "?token=" + config.server.token;
  server.start(*feed);
}

WebMonitor::~WebMonitor() { server.stop(); }

}  // namespace plumbline::web
