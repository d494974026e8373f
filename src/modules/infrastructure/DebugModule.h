#pragma once
#include <functional>
#include <memory>
#include <string>
#include <thread>

#include "framework/Module.h"
#include "inspect/DebugServer.h"

namespace plumbline {

/// What the command line says of the debug port; without such an object there is none.
struct DebugOptions {
  inspect::DebugServerOptions server;
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
  std::unique_ptr<inspect::Inspector> inspector_;
  std::unique_ptr<inspect::DebugServer> server_;
  int endDescriptor_ = -1;
  std::thread thread_;
};

}  // namespace plumbline
