#include "framework/Platform.h"

namespace plumbline {
namespace {

/// No robot at all: an agent that looks at another one over the network. Its robot is none, so modules that
/// want one are not for it.
class WatcherPlatform : public Platform {
public:
  void declareOptions(CommandLine&) override {}
  std::vector<std::string> configFolders(const std::string&) const override { return {}; }
  void addObjects(ModuleObjects&, std::function<void(const std::string&)>) const override {}
  std::vector<NeededModule> neededModules() const override {
    return {{"WallClock", "has no clock to run by"}};
  }
  std::string examples() const override {
    return "  bin/agent --platform watcher --debug 3301                look at the agent of "
           "NetworkModule.yaml\n";
  }
};

MAKE_PLATFORM("watcher", WatcherPlatform)

}  // namespace
}  // namespace plumbline
