#pragma once
#include <string>
#include <typeinfo>

#include "framework/Config.h"
#include "framework/Debug.h"
#include "framework/Log.h"
#include "framework/ModuleObjects.h"
#include "framework/StopSignal.h"

namespace plumbline {

/// What a module gets when it is made.
struct ModuleContext {
  std::string module;
  std::string thread;
  ConfigStore& config;
  ModuleObjects& objects;
  StopSignal& stop;

  /// The context for modules made on this thread now. A module made without the framework (in a unit test)
  /// gets a context of its own kind, with the config directory "config" and no objects.
  static ModuleContext& current();
  /// Sets the context for as long as it lives.
  class Scope {
  public:
    explicit Scope(ModuleContext& context);
    ~Scope();
    Scope(const Scope&) = delete;
    Scope& operator=(const Scope&) = delete;

  private:
    ModuleContext* before_;
  };
};

/// The objects every module has. To add one for all modules, edit this class or, better, make it a
/// ModuleObject: then nothing here changes, and a module reaches it through object<T>().
class PluginModuleBase {
public:
  /// What the module measured through its debug object.
  const std::map<std::string, std::shared_ptr<Stopwatch>>& debugStopwatches() const {
    return debug.stopwatches();
  }

protected:
  PluginModuleBase() : PluginModuleBase(ModuleContext::current()) {}

  Log log;
  Config config;
  Debug debug;

  /// The agent's object of type T (see ModuleObjects). Throws ConfigurationError if there is none.
  template <typename T>
  T& object() const {
    T* found = findObject<T>();
    if (!found) missingObject(typeid(T).name());
    return *found;
  }
  /// The same, or null.
  template <typename T>
  T* findObject() const {
    return objects_.find<T>();
  }

  /// For parametersChanged(): values that do not fit together. Throws ConfigurationError "Module.key
  /// message".
  [[noreturn]] void refuse(const std::string& key, const std::string& message) const;

  /// Ends the agent after this step: main returns exitCode and prints the reason. The first request counts.
  void requestStop(int exitCode, const std::string& reason) { stop_.request(exitCode, reason); }
  bool stopRequested() const { return stop_.requested(); }
  /// Becomes readable when the agent is to end: a module that waits for input polls it too.
  int stopDescriptor() const { return stop_.fileDescriptor(); }

private:
  explicit PluginModuleBase(ModuleContext& context);
  [[noreturn]] void missingObject(const char* type) const;

  ModuleObjects& objects_;
  StopSignal& stop_;
};

}  // namespace plumbline
