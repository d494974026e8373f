#pragma once
#include <chrono>
#include <memory>
#include <string>
#include <vector>

#include "framework/Module.h"

namespace plumbline {

/// One call of a cycle: a module's execute, or its update of one representation.
struct Step {
  std::string module;
  std::string representation;  ///< empty: execute
  std::string label;           ///< `Module:execute` or `Module:updateRepresentation`
  std::size_t index;           ///< in the thread's cycle
  Module* instance;
  void (*call)(Module& module, Representation& value);  ///< null: execute
  Representation* value;
  bool isExecute() const { return call == nullptr; }
};

/// The thread a plugin works in.
struct ThreadInfo {
  std::string name;
  int priority;
  std::vector<Step> steps;  ///< in their order
  double rate = 0;          ///< cycles per second that modules.cfg states; 0: none
};

/// Extends the framework without changing it: called around every step of a thread. Each thread has an object
/// of its own, so that a plugin needs no locks for what it keeps.
class Plugin {
public:
  using Clock = std::chrono::steady_clock;
  struct Duration {
    Clock::time_point begin, end;
  };

  virtual ~Plugin() = default;
  /// On the thread, before its first and after its last cycle. `thread` stays valid in between.
  virtual void threadStarted(const ThreadInfo&) {}
  virtual void threadStopped() {}
  virtual void cycleStarted() {}
  virtual void beforeExecute(const Step&) {}
  virtual void afterExecute(const Step&, const Duration&) {}
  virtual void beforeUpdate(const Step&) {}
  virtual void afterUpdate(const Step&, const Duration&) {}
  virtual void cycleFinished(const Duration&) {}
};

/// The plugins registered with MAKE_PLUGIN; each thread gets one of each, in the order of their names.
class Plugins {
public:
  using Maker = std::unique_ptr<Plugin> (*)();
  static bool add(const std::string& name, Maker maker);
  static std::vector<std::unique_ptr<Plugin>> make();
};

}  // namespace plumbline

/// In a .cpp: every thread of every agent has an object of this class around its steps.
#define MAKE_PLUGIN(Class)                                                               \
  [[maybe_unused]] static const bool plumblinePlugin##Class = ::plumbline::Plugins::add( \
      #Class, []() -> std::unique_ptr<::plumbline::Plugin> { return std::make_unique<Class>(); });
