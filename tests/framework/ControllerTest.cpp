#include "framework/Controller.h"

#include <gtest/gtest.h>

#include <thread>

#include "framework/ConfigurationError.h"
#include "framework/TestModules.h"
#include "framework/TimingPlugin.h"

namespace plumbline {

/// Refuses its configuration in a thread that already runs.
MODULE(LateComplainer)
END_MODULE
class LateComplainer : public LateComplainerBase {
public:
  void execute() override { throw ConfigurationError("config/LateComplainer.yaml:1: too late"); }
};
MAKE_MODULE(LateComplainer)

MODULE(InitThrower)
END_MODULE
class InitThrower : public InitThrowerBase {
public:
  void init() override { throw std::runtime_error("no camera"); }
};
MAKE_MODULE(InitThrower)

namespace {

using Calls = std::vector<std::string>;

TEST(ControllerTest, executesBeforeUpdatesInTheOrderOfTheGraph) {
  Controller controller = makeController("BetaFromAlpha Beta\nAlphaSource Alpha\n");
  EXPECT_EQ(controller.runCycles(2), 2u);
  const Calls cycle = {"AlphaSource:execute", "AlphaSource:updateAlpha", "BetaFromAlpha:execute",
                       "BetaFromAlpha:updateBeta"};
  Calls expected = {"AlphaSource:init"};
  expected.insert(expected.end(), cycle.begin(), cycle.end());
  expected.insert(expected.end(), cycle.begin(), cycle.end());
  EXPECT_EQ(calls(), expected);
  EXPECT_EQ(controller.find<Beta>()->value, 20);
}

TEST(ControllerTest, updatesOnlyWhatModulesCfgNames) {
  Controller controller = makeController("TwinSource Beta\nAlphaSource\n");
  controller.runCycles(1);
  EXPECT_EQ(calls(), (Calls{"AlphaSource:init", "TwinSource:execute", "TwinSource:updateBeta",
                            "AlphaSource:execute"}));
  EXPECT_EQ(controller.find<Alpha>(), nullptr);
}

TEST(ControllerTest, oneModuleIsOneNodeThatRequiresAllBeforeItExecutes) {
  Controller controller = makeController("OptionalReader\nTwinSource Beta\nTwinSource Alpha\n");
  controller.runCycles(1);
  EXPECT_EQ(calls(), (Calls{"TwinSource:execute", "TwinSource:updateBeta", "TwinSource:updateAlpha",
                            "OptionalReader:execute Alpha Beta"}));
}

TEST(ControllerTest, whatIsNotProvidedIsNull) {
  Controller controller = makeController("OptionalReader\n");
  controller.runCycles(1);
  EXPECT_EQ(calls(), (Calls{"OptionalReader:execute"}));
  Controller without = makeController("AlphaFromLastGamma Alpha\n");
  without.runCycles(1);
  EXPECT_EQ(without.find<Alpha>()->value, -1);
}

TEST(ControllerTest, usesReadsTheLastCycle) {
  Controller controller =
      makeController("AlphaFromLastGamma Alpha\nBetaFromAlpha Beta\nGammaFromBeta Gamma\n");
  controller.runCycles(1);
  EXPECT_EQ(controller.find<Alpha>()->value, 1);
  EXPECT_EQ(controller.find<Gamma>()->value, 11);
  controller.runCycles(1);
  EXPECT_EQ(controller.find<Alpha>()->value, 12);
}

TEST(ControllerTest, aModuleEndsTheAgentAfterItsCycle) {
  Controller controller = makeController("Stopper\nAlphaSource Alpha\n");
  EXPECT_EQ(controller.run(), 3);
  EXPECT_EQ(controller.stop().reason(), "three cycles are enough");
  EXPECT_EQ(controller.find<Alpha>()->value, 3);
  EXPECT_EQ(controller.runCycles(5), 0u);
}

TEST(ControllerTest, anExceptionOfAModuleEndsTheAgentAndNamesTheStep) {
  Controller controller = makeController("Thrower\n");
  EXPECT_EQ(controller.run(), 1);
  EXPECT_EQ(controller.stop().reason(), "[default] Thrower:execute: thrown on purpose");
  Controller cycles = makeController("Thrower\n");
  try {
    cycles.runCycles(5);
    FAIL() << "nothing was thrown";
  } catch (const std::runtime_error& error) {
    EXPECT_STREQ(error.what(), "[default] Thrower:execute: thrown on purpose");
  }
}

TEST(ControllerTest, anExceptionOfInitNamesTheModule) {
  Controller controller = makeController("[camera 3]\nInitThrower\n");
  try {
    controller.init();
    FAIL() << "nothing was thrown";
  } catch (const std::runtime_error& error) {
    EXPECT_STREQ(error.what(), "[camera] InitThrower:init: no camera");
  }
}

TEST(ControllerTest, threadsRunAtTheSameTimeAndAllEnd) {
  Controller controller =
      makeController("[a 5]\nAlphaSource Alpha\nThrower\n[b 1]\na Alpha\nOptionalReader\n");
  EXPECT_EQ(controller.run(), 1);
  EXPECT_EQ(controller.stop().reason(), "[a] Thrower:execute: thrown on purpose");
  EXPECT_EQ(controller.find<Alpha>("a")->value, 2);
  EXPECT_NE(controller.find<Alpha>("b"), nullptr);
  EXPECT_EQ(controller.find<Beta>("b"), nullptr);
  EXPECT_EQ(controller.find<Alpha>("nowhere"), nullptr);
  EXPECT_THROW(controller.runCycles(1), std::logic_error);
}

TEST(ControllerTest, aConfigurationErrorComesOutOfAnyThread) {
  Controller single = makeController("LateComplainer\n");
  EXPECT_THROW(single.run(), ConfigurationError);
  Controller two = makeController("[a 1]\nLateComplainer\n[b 1]\nAlphaSource\n");
  try {
    two.run();
    FAIL() << "nothing was thrown";
  } catch (const ConfigurationError& error) {
    EXPECT_STREQ(error.what(), "config/LateComplainer.yaml:1: too late");
  }
}

TEST(ControllerTest, theStopComesFromOutsideAsWell) {
  Controller controller = makeController("[a 1]\nAlphaSource Alpha\n[b 0]\nOptionalReader\n");
  controller.init();
  std::thread other([&] {
    while (controller.timing("b")->cycle().count() < 10) std::this_thread::yield();
    controller.stop().request(0, "enough");
  });
  EXPECT_EQ(controller.run(), 0);
  other.join();
  EXPECT_EQ(controller.stop().reason(), "enough");
}

TEST(ControllerTest, aMissingFileIsAnError) {
  try {
    Controller controller({"/nowhere/modules.cfg", {}});
    FAIL() << "nothing was thrown";
  } catch (const ConfigurationError& error) {
    EXPECT_STREQ(error.what(), "/nowhere/modules.cfg: cannot be read: No such file or directory");
  }
}

}  // namespace
}  // namespace plumbline
