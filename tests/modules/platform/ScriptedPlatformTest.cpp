// A second platform is added by files alone: those of this folder.
#include "ScriptedPlatform.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "framework/Controller.h"
#include "representations/modeling/FallState.h"
#include "representations/motion/MotionSelection.h"

namespace plumbline::test {
namespace {

/// An agent on the platform, as bin/agent makes one.
class ScriptedAgent : public testing::Test {
protected:
  ScriptedAgent() {
    CommandLine line("An agent.");
    platform->declareOptions(line);
    const char* words[] = {"agent", "--walk-after", "2"};
    readCommandLine(line, 3, words);
    ControllerOptions setup;
    setup.modulesConfig = "tests/modules/platform/config/platforms/scripted/modules.cfg";
    setup.configDirectories = {"config", platform->configFolders("config").front()};
    controller = std::make_unique<Controller>(setup);
    platform->addObjects(controller->objects(), [](const std::string&) {});
  }
  simulation::LocalRobot& robot() { return controller->objects().find<ScriptedWorld>()->robot; }
  /// Range of the left knee's angle in so many cycles [rad].
  double kneeRange(int cycles) {
    double lowest = INFINITY, highest = -INFINITY;
    for (int i = 0; i < cycles; ++i) {
      controller->runCycles(1);
      const double angle = robot().sense().angle[lKneePitch];
      lowest = std::min(lowest, angle);
      highest = std::max(highest, angle);
    }
    return highest - lowest;
  }

  const std::unique_ptr<Platform> platform = Platforms::make("scripted");
  std::unique_ptr<Controller> controller;
};

TEST_F(ScriptedAgent, standsAndWalksInPlaceThroughTheModulesOfEveryPlatform) {
  controller->runCycles(60);  // into the stand
  EXPECT_LT(kneeRange(40), 0.02) << "it stands";
  EXPECT_EQ(controller->find<MotionSelection>()->motion, Motion::stand);
  const Vec3 start = robot().torso().pose.translation();
  EXPECT_GT(kneeRange(300), 0.15) << "its feet are lifted";
  EXPECT_EQ(controller->find<MotionSelection>()->motion, Motion::walk);
  EXPECT_EQ(controller->find<FallState>()->posture, Posture::upright);
  EXPECT_FALSE(robot().fallen());
  EXPECT_LT((robot().torso().pose.translation() - start).norm(), 0.3) << "in place";
}

TEST_F(ScriptedAgent, hasTheModulesThatItsPlatformNeeds) {
  for (const NeededModule& needed : platform->neededModules())
    EXPECT_EQ(std::ranges::count_if(
                  controller->threads().front().modules,
                  [&](const ModulePlan& m) { return m.loader->description().name == needed.name; }),
              1)
        << needed.name;
}

}  // namespace
}  // namespace plumbline::test
