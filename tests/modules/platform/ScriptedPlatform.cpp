#include "ScriptedPlatform.h"

namespace plumbline::test {

MAKE_PLATFORM("scripted", ScriptedPlatform)

void ScriptedPlatform::declareOptions(CommandLine& app) {
  app.option("--walk-after", options_->walkAfter, "seconds that the robot stands before it walks");
}

std::vector<std::string> ScriptedPlatform::configFolders(const std::string& config) const {
  return {config + "/robots/simspark_type0"};
}

void ScriptedPlatform::addObjects(ModuleObjects& objects, std::function<void(const std::string&)>) const {
  objects.set(options_);
  objects.set(std::make_shared<ScriptedWorld>());
  objects.set(std::make_shared<RobotModel>(simsparkRobot(0)));
}

std::vector<NeededModule> ScriptedPlatform::neededModules() const {
  return {{"ScriptedSensors", "feels nothing"}, {"ScriptedMotors", "moves nothing"}};
}

}  // namespace plumbline::test
