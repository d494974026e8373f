#include "modules/infrastructure/DebugModule.h"

#include <sys/eventfd.h>
#include <unistd.h>

#include <cstdint>
#include <stdexcept>

#include "framework/ConfigurationError.h"
#include "framework/ThreadPriority.h"

namespace plumbline {

MAKE_MODULE(DebugModule)

namespace {
constexpr int stepsOfNice = 14;
}

void DebugModule::init() {
  const DebugOptions* options = findObject<DebugOptions>();
  auto* agent = findObject<AgentDebug>();
  if (!options || !agent) return;
  inspector_ = std::make_unique<inspect::Inspector>(*agent);
  try {
    viewer_ = std::make_unique<inspect::DrawingViewer>(options->viewer, object<inspect::DrawingOwner>());
    server_ = std::make_unique<inspect::DebugServer>(*inspector_, options->server);
    if (options->serve) page_ = options->serve(*server_);
  } catch (const std::runtime_error& error) {
    throw ConfigurationError(error.what());
  }
  inspector_->showDrawings(
      [this](const std::string& id, const Drawing& drawing) { viewer_->show(id, drawing); });
  switchOn(options->drawings);
  endDescriptor_ = eventfd(0, EFD_CLOEXEC);
  if (endDescriptor_ < 0) throw std::runtime_error("no descriptor is left for the debug port");
  thread_ = std::thread([this] {
    applyThreadPriority(0, stepsOfNice);
    server_->serve(endDescriptor_);
  });
  if (!options->server.listens) return;
  const std::string line =
      "debug port " + options->server.address + ':' + std::to_string(server_->port()) + ": bin/rdb";
  log << line;
  if (options->notify)
    options->notify(line + (server_->port() == inspect::DebugServerOptions::standardPort
                                ? ""
                                : " " + options->server.address + ':' + std::to_string(server_->port())));
}

/// As a client that asks for them and goes: what it switched on stays.
void DebugModule::switchOn(const std::vector<std::string>& drawings) {
  if (drawings.empty()) return;
  const int client = inspector_->open([this](std::string_view answer, bool) {
    if (answer != "ok") log.error() << answer;
    return true;
  });
  for (const std::string& drawing : drawings) {
    // No cycle has got there yet.
    DebugPoints::sites().expect(drawing, DebugKind::drawing);
    inspector_->command(client, "dr " + drawing);
  }
  inspector_->close(client);
}

DebugModule::~DebugModule() {
  page_.reset();
  if (thread_.joinable()) {
    const std::uint64_t one = 1;
    if (write(endDescriptor_, &one, sizeof(one)) < 0) log.error() << "the debug port does not end";
    thread_.join();
  }
  if (endDescriptor_ >= 0) ::close(endDescriptor_);
}

}  // namespace plumbline
