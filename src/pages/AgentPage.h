#pragma once
#include <string>

#include "pages/DebugPages.h"
#include "pages/PageServer.h"

namespace plumbline::pages {

/// The page of a running agent: its modules, values, drawings and parameters, in threads of its own until it
/// is destroyed.
class AgentPage {
public:
  static constexpr int standardPort = 8090;

  /// `server` must outlive this. Throws std::runtime_error, one line, for what cannot be had.
  AgentPage(PageServer::Config config, inspect::DebugServer& server);
  ~AgentPage() { server_.stop(); }

  /// "http://localhost:8090/", with the token if there is one.
  std::string address() const;

private:
  PageServer::Config config_;
  DebugPages pages_;
  PageServer server_;
};

}  // namespace plumbline::pages
