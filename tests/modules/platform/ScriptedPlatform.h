#pragma once
#include "framework/Platform.h"
#include "simspark/LeagueRobots.h"
#include "simulation/league/LocalRobot.h"

namespace plumbline::test {

/// The world of the platform "scripted": one robot alone, in this process.
struct ScriptedWorld {
  simulation::LocalRobot robot{simsparkRobot(0)};
};

struct ScriptedOptions {
  double walkAfter = 1;  ///< it stands so long, and then walks in place [s]
};

/// A second platform, made of the files of this folder alone: a robot that follows a script.
class ScriptedPlatform : public Platform {
public:
  void declareOptions(CommandLine& app) override;
  std::vector<std::string> configFolders(const std::string& config) const override;
  void addObjects(ModuleObjects& objects, std::function<void(const std::string&)> notify) const override;
  std::vector<NeededModule> neededModules() const override;

private:
  const std::shared_ptr<ScriptedOptions> options_ = std::make_shared<ScriptedOptions>();
};

}  // namespace plumbline::test
