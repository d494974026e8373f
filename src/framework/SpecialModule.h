#pragma once
#include <cstddef>
#include <map>
#include <memory>
#include <string>

#include "framework/RepresentationLoader.h"

namespace plumbline {

struct ThreadPlan;

/// A module outside the module graph that can provide any representation, in several threads: it copies from
/// another thread, a network or a log file. It works before the first and after the last module of a cycle.
/// In modules.cfg it is written like a module. One object per thread that names it.
class SpecialModule {
public:
  virtual ~SpecialModule() = default;
  /// For each line `name Representation`: this object fills `target` from now on. Before the first cycle.
  virtual void provide(const RepresentationLoader& loader, Representation& target) = 0;
  /// Each representation of the thread that somebody else provides, for reading. Before the first cycle.
  virtual void offer(const RepresentationLoader&, const Representation&) {}
  /// The whole thread, after the calls above; it stays as long as this object.
  virtual void planned(const ThreadPlan&) {}

  /// cycle: the thread continues. unseen: the same, but debug requests are not served in that cycle. wait: no
  /// cycle now; values can be read, and turn() is called again. restart: modules and representations are
  /// constructed again, as at the agent's start, and turn() is called again.
  enum class Turn { cycle, unseen, wait, restart };
  /// Before each cycle; may sleep for less than a tenth of a second.
  virtual Turn turn() { return Turn::cycle; }
  virtual void beginCycle() {}
  /// Before each module of the plan executes.
  virtual void beforeModule(std::size_t) {}
  virtual void endCycle() {}
};

/// The special modules of this program by the name they have in modules.cfg. While one is made,
/// ModuleContext::current() is the agent's.
class SpecialModules {
public:
  using Maker = std::unique_ptr<SpecialModule> (*)(const std::string& thread);
  static std::map<std::string, Maker>& makers();
  static bool add(const std::string& name, Maker maker) { return makers().emplace(name, maker).second; }
};

}  // namespace plumbline

/// In a .cpp: MAKE_SPECIAL_MODULE(network, NetworkModule); the constructor takes the thread's name.
#define MAKE_SPECIAL_MODULE(name, Class)                                                         \
  [[maybe_unused]] static const bool plumblineSpecial##Class = ::plumbline::SpecialModules::add( \
      #name, [](const std::string& thread) -> std::unique_ptr<::plumbline::SpecialModule> {      \
        return std::make_unique<Class>(thread);                                                  \
      });
