#pragma once
#include <functional>
#include <memory>
#include <string>
#include <thread>
#include <vector>

#include "framework/Module.h"
#include "inspect/DebugServer.h"
#include "inspect/DrawingViewer.h"

namespace plumbline {

/// What the command line says of the debug port; without such an object there is none.
struct DebugOptions {
  inspect::DebugServerOptions server;
  inspect::ViewerOptions viewer;      ///< of drawings that are switched on
  std::vector<std::string> drawings;  ///< ids of those that are on from the start
  /// Makes something that talks to the server for as long as it lives, as a page; may be empty.
  std::function<std::shared_ptr<void>(inspect::DebugServer&)> serve;
  std::function<void(const std::string&)> notify;  ///< takes a line that names the port; may be empty
};

MODULE(DebugModule)
END_MODULE

/// Opens the debug port when the agent was started with one, and switches on the drawings that its command
/// line names. A thread of the lowest priority serves both: the module itself does nothing in a cycle.
class DebugModule : public DebugModuleBase {
public:
  ~DebugModule() override;
  void init() override;

private:
  void switchOn(const std::vector<std::string>& drawings);

  std::unique_ptr<inspect::DrawingViewer> viewer_;
  std::unique_ptr<inspect::Inspector> inspector_;
  std::unique_ptr<inspect::DebugServer> server_;
  std::shared_ptr<void> page_;
  int endDescriptor_ = -1;
  std::thread thread_;
};

}  // namespace plumbline
