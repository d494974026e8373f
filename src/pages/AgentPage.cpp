#include "pages/AgentPage.h"

#include "pages/PagePlace.h"

namespace plumbline::pages {
namespace {

PageServer::Config ofAgent(PageServer::Config config) {
  config.index = "agent.html";
  return completed(std::move(config), {"--web-address", "--web-token"});
}

}  // namespace

AgentPage::AgentPage(PageServer::Config config, inspect::DebugServer& server)
    : config_(ofAgent(std::move(config))), pages_(server), server_(config_, pages_) {
  server_.start();
}

std::string AgentPage::address() const { return addressOf(config_, server_.port()); }

}  // namespace plumbline::pages
