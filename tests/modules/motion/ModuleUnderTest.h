#pragma once
#include <fstream>
#include <memory>
#include <string>
#include <vector>

#include "framework/ConfigFile.h"
#include "framework/ModuleObjects.h"
#include "framework/ModuleParameters.h"
#include "framework/PluginModuleBase.h"
#include "framework/StopSignal.h"

namespace plumbline {

/// A module with its configuration from these directories, without a module graph; its inputs are set by
/// hand. init() has been called.
template <typename M>
class ModuleUnderTest {
public:
  explicit ModuleUnderTest(const std::string& name, std::vector<std::string> directories = {"config"})
      : store(std::move(directories)), context{name, "test", store, objects, stop}, scope(context) {
    module = std::make_unique<M>();
    configureModule(*module, M::moduleDescription(), store);
    module->init();
  }
  M* operator->() { return module.get(); }

private:
  ConfigStore store;
  ModuleObjects objects;
  StopSignal stop;
  ModuleContext context;
  ModuleContext::Scope scope;
  std::unique_ptr<M> module;
};

}  // namespace plumbline
