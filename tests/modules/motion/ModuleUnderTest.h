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
      : store_(std::move(directories)), context_{name, "test", store_, objects_, stop_}, scope_(context_) {
    module_ = std::make_unique<M>();
    configureModule(*module_, M::moduleDescription(), store_);
    module_->init();
  }
  M* operator->() { return module_.get(); }

private:
  ConfigStore store_;
  ModuleObjects objects_;
  StopSignal stop_;
  ModuleContext context_;
  ModuleContext::Scope scope_;
  std::unique_ptr<M> module_;
};

}  // namespace plumbline
