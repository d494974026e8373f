#pragma once
#include <functional>
#include <memory>
#include <string>
#include <thread>

#include "framework/Module.h"
#include "inspect/DebugServer.h"
#include "inspect/DrawingViewer.h"

namespace plumbline {

/// What the command line says of the debug port; without such an object there is none.
struct DebugOptions {
  inspect::DebugServerOptions server;
  inspect::ViewerOptions viewer;  ///< of drawings that are switched on
  /// Makes something that talks to the server for as long as it lives, as a page; may be empty.
  std::function<std::shared_ptr<void>(inspect::DebugServer&)> serve;
  std::function<void(const std::string&)> tell;  ///< takes a line that names the port; may be empty
};

MODULE(DebugModule)
END_MODULE

/// Opens the debug port when the agent was started with one, and serves it in a thread of its own, whose
/// priority is the lowest: the module itself does nothing in a cycle.
class DebugModule : public DebugModuleBase {
public:
  ~DebugModule() override;
  void init() override;

private:
  std::unique_ptr<inspect::DrawingViewer> viewer_;
  std::unique_ptr<inspect::Inspector> inspector_;
  std::unique_ptr<inspect::DebugServer> server_;
  std::shared_ptr<void> page_;
  int endDescriptor_ = -1;
  std::thread thread_;
};

}  // namespace plumbline
