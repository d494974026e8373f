#pragma once
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "framework/CommandLine.h"
#include "framework/ModuleObjects.h"

namespace plumbline {

/// A module that every agent needs, and the problem without it ("receives nothing from the robot").
struct NeededModule {
  std::string name, problem;
};

/// What an agent runs on: a league's server, a robot, a simulation in the program. A platform is a folder of
/// modules that provides the representations of doc/reference/platforms.md and receives the joints' targets,
/// one object of this class, registered with MAKE_PLATFORM, and config/platforms/NAME/modules.cfg. No other
/// code depends on it. In order: declareOptions, (the command line is read), check, configFolders,
/// addObjects.
class Platform {
public:
  virtual ~Platform() = default;

  /// Adds the platform's own options of bin/agent; their values stay in this object.
  virtual void declareOptions(CommandLine& app) = 0;
  /// Throws ConfigurationError for options that cannot be.
  virtual void check() const {}
  /// Folders whose files override those of the folder `config`: those of the robot that the options chose.
  virtual std::vector<std::string> configFolders(const std::string& config) const = 0;
  /// Gives the modules the platform's objects: its options, the robot's model (RobotModel). `notify` prints a
  /// line for the user.
  virtual void addObjects(ModuleObjects& objects, std::function<void(const std::string&)> notify) const = 0;
  virtual std::vector<NeededModule> neededModules() const { return {}; }
  /// Example command lines for --help, a line each.
  virtual std::string examples() const { return {}; }
};

/// The platforms registered with MAKE_PLATFORM.
class Platforms {
public:
  using Maker = std::unique_ptr<Platform> (*)();
  static bool add(const std::string& name, Maker maker);
  /// Sorted.
  static std::vector<std::string> names();
  /// Throws ConfigurationError for an unknown name, with the nearest one or all.
  static std::unique_ptr<Platform> make(const std::string& name);
};

/// The platform that a command line chooses with `--platform NAME`; `fallback` if it does not say. What else
/// is in the line is not looked at: which options there are depends on the platform.
std::string chosenPlatform(int argc, const char* const* argv, const std::string& fallback);

}  // namespace plumbline

/// In a .cpp: the platform `name` is an object of this class.
#define MAKE_PLATFORM(name, Class)                                                           \
  [[maybe_unused]] static const bool plumblinePlatform##Class = ::plumbline::Platforms::add( \
      name, []() -> std::unique_ptr<::plumbline::Platform> { return std::make_unique<Class>(); });
