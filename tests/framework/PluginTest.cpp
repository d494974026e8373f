#include "framework/Plugin.h"

#include <gtest/gtest.h>

#include "framework/SpecialModule.h"
#include "framework/TestModules.h"

namespace plumbline {
namespace {

bool recording = false;

/// Writes down every hook among the calls of the modules.
class RecordingPlugin : public Plugin {
public:
  void threadStarted(const ThreadInfo& thread) override {
    add("started " + thread.name + " " + std::to_string(thread.priority));
    for (const Step& step : thread.steps) add("has " + step.label);
  }
  void threadStopped() override { add("stopped"); }
  void cycleStarted() override { add("cycle"); }
  void beforeExecute(const Step& step) override { add("before " + step.label); }
  void afterExecute(const Step& step, const Duration& d) override { after(step, d); }
  void beforeUpdate(const Step& step) override { add("before " + step.label); }
  void afterUpdate(const Step& step, const Duration& d) override {
    after(step, d);
    if (recording && step.representation == "Alpha") static_cast<Alpha*>(step.value)->value += 100;
  }
  void cycleFinished(const Duration&) override { add("cycle finished"); }

private:
  static void add(const std::string& text) {
    if (recording) addCall(text);
  }
  static void after(const Step& step, const Duration& duration) {
    EXPECT_GE(duration.end, duration.begin);
    add("after " + step.label);
  }
};
MAKE_PLUGIN(RecordingPlugin)

TEST(PluginTest, isCalledAroundEveryStepAndCycle) {
  recording = true;
  {
    Controller controller = makeController("[main 4]\nAlphaSource Alpha\nBetaFromAlpha Beta\n");
    controller.runCycles(1);
    EXPECT_EQ(controller.find<Beta>()->value, 1010);  // the plugin has changed Alpha
  }
  recording = false;
  const std::vector<std::string> expected = {"AlphaSource:init",
                                             "started main 4",
                                             "has AlphaSource:execute",
                                             "has AlphaSource:updateAlpha",
                                             "has BetaFromAlpha:execute",
                                             "has BetaFromAlpha:updateBeta",
                                             "cycle",
                                             "before AlphaSource:execute",
                                             "AlphaSource:execute",
                                             "after AlphaSource:execute",
                                             "before AlphaSource:updateAlpha",
                                             "AlphaSource:updateAlpha",
                                             "after AlphaSource:updateAlpha",
                                             "before BetaFromAlpha:execute",
                                             "BetaFromAlpha:execute",
                                             "after BetaFromAlpha:execute",
                                             "before BetaFromAlpha:updateBeta",
                                             "BetaFromAlpha:updateBeta",
                                             "after BetaFromAlpha:updateBeta",
                                             "cycle finished",
                                             "stopped"};
  EXPECT_EQ(calls(), expected);
}

/// Provides whatever it is asked for, and keeps what it was offered.
class Loopback : public SpecialModule {
public:
  explicit Loopback(const std::string& thread) { addCall("Loopback in " + thread); }
  void provide(const RepresentationLoader& loader, Representation& target) override {
    addCall("provides " + loader.name());
    if (loader.name() == "Alpha") alpha_ = static_cast<Alpha*>(&target);
  }
  void offer(const RepresentationLoader& loader, const Representation& value) override {
    addCall("offered " + loader.name());
    if (loader.name() == "Beta") beta_ = static_cast<const Beta*>(&value);
  }
  void beginCycle() override { alpha_->value = 5; }
  void endCycle() override { addCall("Beta is " + std::to_string(beta_->value)); }

private:
  Alpha* alpha_ = nullptr;
  const Beta* beta_ = nullptr;
};
MAKE_SPECIAL_MODULE(loopback, Loopback)

}  // namespace

TEST(SpecialModuleTest, providesAnythingAndSeesTheRest) {
  Controller controller = makeController("[main 1]\nBetaFromAlpha Beta\nloopback Alpha\n");
  controller.runCycles(1);
  EXPECT_EQ(calls(),
            (std::vector<std::string>{"Loopback in main", "provides Alpha", "offered Beta",
                                      "BetaFromAlpha:execute", "BetaFromAlpha:updateBeta", "Beta is 50"}));
}

}  // namespace plumbline
