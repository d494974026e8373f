#include "ServoPlatform.h"

namespace plumbline::test {

MAKE_PLATFORM("servo", ServoPlatform)

std::vector<std::string> ServoPlatform::configFolders(const std::string& config) const {
  return {config + "/robots/nao_v5"};
}

void ServoPlatform::addObjects(ModuleObjects& objects, std::function<void(const std::string&)>) const {
  auto world = std::make_shared<ServoWorld>();
  world->robot->restart(std::vector<double>(world->mechanism.joints.size(), 0), 0);
  objects.set(world);
  objects.set(std::make_shared<RobotModel>(world->humanoid.model()));
}

std::vector<NeededModule> ServoPlatform::neededModules() const {
  return {{"ServoSensors", "feels nothing"}, {"ServoMotors", "moves nothing"}};
}

}  // namespace plumbline::test
