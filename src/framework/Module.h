#pragma once
#include "framework/ModuleDescription.h"
#include "framework/PluginModuleBase.h"
#include "framework/Registry.h"

namespace plumbline {

/// The common base of all modules. A module is declared so (and made known by MAKE_MODULE in its .cpp):
///
///     MODULE(BallLocator)
///       REQUIRES(BallPercept)  // const BallPercept* theBallPercept: updated before this module executes
///       REQUIRES_IF_PROVIDED(Odometry)  // the same if any module provides it, otherwise null
///       REQUIRES_ALL(TeamBall) // std::vector<const TeamBall*> allTeamBalls: every one of that kind there is
///       USES(RobotPose)        // no effect on the order: may be of the last cycle; null if not provided
///       PROVIDES(BallPos)      // void update(BallPos* theBallPos) must be implemented
///       PARAMETER(double, forgetSeconds, 10, "s", Range(0, 100), "time after which an unseen ball is lost")
///     END_MODULE
///     class BallLocator : public BallLocatorBase { ... };
class Module : public PluginModuleBase {
public:
  Module();
  Module(const Module&) = delete;
  Module& operator=(const Module&) = delete;
  virtual ~Module();

  /// After the parameters were read, before init(), and each time one of them was changed while the module
  /// runs: derives what depends on them. Refuses values that do not fit together by refuse().
  virtual void parametersChanged() {}
  /// Once, before the first cycle; all representations are there.
  virtual void init() {}
  /// In every cycle, before the module's updates.
  virtual void execute() {}
};

}  // namespace plumbline

#define MODULE(Name)                                                                              \
  class Name;                                                                                     \
  class Name##Base : public ::plumbline::Module {                                                 \
    using ThisModuleBase = Name##Base;                                                            \
                                                                                                  \
  public:                                                                                         \
    static ::plumbline::ModuleDescription& moduleDescription() {                                  \
      static ::plumbline::ModuleDescription description(#Name, __FILE__);                         \
      return description;                                                                         \
    }                                                                                             \
    static ::plumbline::ParameterList& parameterList() { return moduleDescription().parameters; } \
    static ThisModuleBase* plumblineOwner(void* module) {                                         \
      return static_cast<ThisModuleBase*>(static_cast<::plumbline::Module*>(module));             \
    }

#define PLUMBLINE_INPUT(Name, inputKind)                                                                   \
protected:                                                                                                 \
  const Name* the##Name = nullptr;                                                                         \
                                                                                                           \
private:                                                                                                   \
  static void plumblineBind##Name(::plumbline::Module& module, const ::plumbline::Representation* value) { \
    static_cast<ThisModuleBase&>(module).the##Name = static_cast<const Name*>(value);                      \
  }                                                                                                        \
  inline static const bool plumblineInput##Name = moduleDescription().add(                                 \
      Name::representationName(), ::plumbline::ModuleInput::Kind::inputKind, &plumblineBind##Name);        \
  static void plumblineEnd##Name() {}

#define REQUIRES(Name) PLUMBLINE_INPUT(Name, required)
#define REQUIRES_IF_PROVIDED(Name) PLUMBLINE_INPUT(Name, requiredIfProvided)
#define USES(Name) PLUMBLINE_INPUT(Name, used)

/// The list is `all` and the kind's name with an s: allMotionOutputs, in the order of the lines of
/// modules.cfg.
#define PLUMBLINE_INPUTS(Kind_, inputKind)                                                          \
protected:                                                                                          \
  std::vector<const Kind_*> all##Kind_##s;                                                          \
                                                                                                    \
private:                                                                                            \
  static void plumblineBindAll##Kind_(::plumbline::Module& module,                                  \
                                      const ::plumbline::Representation* value) {                   \
    static_cast<ThisModuleBase&>(module).all##Kind_##s.push_back(static_cast<const Kind_*>(value)); \
  }                                                                                                 \
  inline static const bool plumblineInputs##Kind_ = moduleDescription().addAll(                     \
      Kind_::kindName(), ::plumbline::ModuleInput::Kind::inputKind, &plumblineBindAll##Kind_);      \
  static void plumblineEndAll##Kind_() {}

#define REQUIRES_ALL(Kind) PLUMBLINE_INPUTS(Kind, required)
#define USES_ALL(Kind) PLUMBLINE_INPUTS(Kind, used)

#define PROVIDES(Name)                                                                                 \
public:                                                                                                \
  virtual void update(Name* the##Name) = 0;                                                            \
                                                                                                       \
private:                                                                                               \
  static void plumblineUpdate##Name(::plumbline::Module& module, ::plumbline::Representation& value) { \
    static_cast<ThisModuleBase&>(module).update(static_cast<Name*>(&value));                           \
  }                                                                                                    \
  inline static const bool plumblineOutput##Name =                                                     \
      moduleDescription().add(::plumbline::representationLoader<Name>(), &plumblineUpdate##Name);      \
  static void plumblineProvided##Name() {}

#define END_MODULE \
  }                \
  ;

/// In the module's .cpp: makes the module known. Inside namespace plumbline or outside.
#define MAKE_MODULE(Name)                                                          \
  [[maybe_unused]] static const ::plumbline::ModuleLoader& plumblineLoader##Name = \
      []() -> const ::plumbline::ModuleLoader& {                                   \
    using namespace ::plumbline;                                                   \
    static const ModuleLoaderOf<Name> loader;                                      \
    return loader;                                                                 \
  }();
