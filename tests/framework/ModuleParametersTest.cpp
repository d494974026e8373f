#include "framework/ModuleParameters.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>

#include "framework/ConfigFile.h"
#include "framework/ConfigurationError.h"
#include "framework/Module.h"
#include "support/Thrown.h"

namespace plumbline {
namespace {

struct Filter {
  PARAMETERS(Filter)
  PARAMETER(double, timeConstant, 0.5, "s", Range(0.1, 10), "of the low-pass")
};

MODULE(Tuned)
  PARAMETER_GROUP(Filter, filter, "of the sensor")
  PARAMETER(double, lower, 1, "m", Range(0, 100), "lower end")
  PARAMETER(double, upper, 2, "m", Range(0, 100), "upper end")
  PARAMETER_CHOICE(mode, "slow", "how", "slow", "fast")
END_MODULE
class Tuned : public TunedBase {
public:
  void parametersChanged() override {
    if (lower > upper) refuse("lower", "must not be above upper");
    width = upper - lower;
  }
  double width = 0;
};

struct ModuleParametersTest : testing::Test {
  ModuleParametersTest() { std::filesystem::create_directories(folder); }
  ~ModuleParametersTest() override { std::filesystem::remove_all(folder); }

  std::unique_ptr<Tuned> configured(const std::string& yaml) {
    if (!yaml.empty()) std::ofstream(folder + "/Tuned.yaml") << yaml;
    store = std::make_unique<ConfigStore>(std::vector<std::string>{folder});
    context = std::make_unique<ModuleContext>(ModuleContext{"Tuned", "test", *store, objects, stop});
    const ModuleContext::Scope scope(*context);
    auto module = std::make_unique<Tuned>();
    configureModule(*module, Tuned::moduleDescription(), *store);
    return module;
  }
  std::string refused(const std::string& yaml) {
    return thrownBy([&] { configured(yaml); });
  }

  std::string folder = testing::TempDir() + "moduleParameters";
  std::unique_ptr<ConfigStore> store;
  ModuleObjects objects;
  StopSignal stop;
  std::unique_ptr<ModuleContext> context;
};

TEST_F(ModuleParametersTest, aModuleNeedsNoFile) {
  const auto module = configured("");
  EXPECT_EQ(module->upper, 2);
  EXPECT_EQ(module->width, 1);
}

TEST_F(ModuleParametersTest, theFileHoldsWhatDeviates) {
  const auto module = configured("upper: 5\nfilter:\n  timeConstant: 2\nmode: fast\n");
  EXPECT_EQ(module->upper, 5);
  EXPECT_EQ(module->lower, 1);
  EXPECT_EQ(module->filter.timeConstant, 2);
  EXPECT_EQ(module->mode, "fast");
  EXPECT_EQ(module->width, 4);
  store->checkUnknown();
}

TEST_F(ModuleParametersTest, mistakesNameFileAndLine) {
  const std::string file = folder + "/Tuned.yaml";
  EXPECT_EQ(refused("upper: 500\n"), file + ":1: upper must be within [0, 100], not 500");
  EXPECT_EQ(refused("\nupper: wide\n"), file + ":2: upper must be a number, not \"wide\"");
  EXPECT_EQ(refused("filter:\n  timeConstant: 0\n"),
            file + ":2: filter.timeConstant must be within [0.1, 10], not 0");
  EXPECT_EQ(refused("mode: quick\n"), file + ":1: mode must be slow or fast, not \"quick\"");
  EXPECT_EQ(refused("lower: 3\n"), file + ":1: lower must not be above upper");
  EXPECT_EQ(refused("upper: 0\n"), "Tuned.lower must not be above upper") << "no line sets lower";
  configured("uper: 3\n");
  EXPECT_EQ(thrownBy([&] { store->checkUnknown(); }),
            file + ":1: unknown key \"uper\"; did you mean \"upper\"?");
}

TEST_F(ModuleParametersTest, areReadAndSetByName) {
  const auto module = configured("");
  const ModuleDescription& description = Tuned::moduleDescription();
  EXPECT_EQ(moduleParameter(*module, description, "filter.timeConstant"), "0.5");
  setModuleParameter(*module, description, "upper", "7.5");
  EXPECT_EQ(module->upper, 7.5);
  EXPECT_EQ(module->width, 6.5) << "the module gets it";
}

TEST_F(ModuleParametersTest, aRefusedValueLeavesTheOldOne) {
  const auto module = configured("");
  const ModuleDescription& description = Tuned::moduleDescription();
  const auto refusedSet = [&](const std::string& path, const std::string& text) {
    return thrownBy([&] { setModuleParameter(*module, description, path, text); });
  };
  EXPECT_EQ(refusedSet("upper", "-1"), "Tuned.upper must be within [0, 100], not -1");
  EXPECT_EQ(refusedSet("upper", "[1, 2]"), "Tuned.upper must be a number, not a list of 2");
  EXPECT_EQ(refusedSet("upper", "1\n---\n2"), "Tuned.upper takes one value");
  EXPECT_EQ(refusedSet("mode", "quick"), "Tuned.mode must be slow or fast, not \"quick\"");
  EXPECT_EQ(refusedSet("lower", "3"), "Tuned.lower must not be above upper");
  EXPECT_EQ(refusedSet("loewr", "3"), "module Tuned has no parameter loewr; did you mean \"lower\"?");
  EXPECT_EQ(module->upper, 2);
  EXPECT_EQ(module->lower, 1);
  EXPECT_EQ(module->mode, "slow");
  EXPECT_EQ(module->width, 1);
}

}  // namespace
}  // namespace plumbline
