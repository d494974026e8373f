#pragma once
#include <memory>

#include "framework/Platform.h"
#include "representations/motion/MotionRequest.h"
#include "robot/HumanoidModel.h"
#include "robot/MechanismFile.h"
#include "servo/RobotSimulation.h"

namespace plumbline::test {

/// The world of the platform "servo": a NAO with position servos alone in Bullet, and what it is to do.
struct ServoWorld {
  const Mechanism mechanism = findMechanism("nao_v5");
  const Humanoid humanoid{mechanism};
  const std::unique_ptr<servo::RobotSimulation> robot = servo::RobotSimulations::make("bullet", mechanism);
  MotionRequest wish;
};

/// A third platform, whose robot is not one of the league's: another number of joints, position servos, 100
/// Hz, sensors below the soles.
class ServoPlatform : public Platform {
public:
  void declareOptions(CommandLine&) override {}
  std::vector<std::string> configFolders(const std::string& config) const override;
  void addObjects(ModuleObjects& objects, std::function<void(const std::string&)> notify) const override;
  std::vector<NeededModule> neededModules() const override;
};

}  // namespace plumbline::test
