#include "framework/PluginModuleBase.h"

#include <cxxabi.h>

#include <cstdlib>

#include "framework/ConfigFile.h"
#include "framework/ConfigurationError.h"

namespace plumbline {
namespace {

thread_local ModuleContext* currentContext = nullptr;

/// For modules made outside any agent.
struct Standalone {
  ConfigStore config{{"config"}};
  ModuleObjects objects;
  StopSignal stop;
  ModuleContext context{"module", "none", config, objects, stop};
};

}  // namespace

ModuleContext& ModuleContext::current() {
  if (currentContext) return *currentContext;
  static Standalone standalone;
  return standalone.context;
}

ModuleContext::Scope::Scope(ModuleContext& context) : before_(currentContext) { currentContext = &context; }
ModuleContext::Scope::~Scope() { currentContext = before_; }

PluginModuleBase::PluginModuleBase(ModuleContext& context)
    : log(context.module),
      config(context.config, context.module),
      objects_(context.objects),
      stop_(context.stop) {}

void PluginModuleBase::refuse(const std::string& key, const std::string& message) const {
  config.refuse(key, message);
}

void PluginModuleBase::missingObject(const char* type) const {
  int status = 0;
  char* name = abi::__cxa_demangle(type, nullptr, nullptr, &status);
  const std::string text = name ? name : type;
  std::free(name);
  throw ConfigurationError("module " + log.source() + " needs an object of type " + text +
                           ", which this program does not have");
}

}  // namespace plumbline
