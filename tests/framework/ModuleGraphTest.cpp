#include "framework/ModuleGraph.h"

#include <gtest/gtest.h>

#include "framework/ConfigurationError.h"
#include "framework/TestModules.h"

namespace plumbline {
namespace {

std::vector<ThreadPlan> plan(const std::string& text) {
  return planThreads(parseModulesConfig(text, "modules.cfg"));
}

std::string errorOf(const std::string& text) {
  try {
    plan(text);
  } catch (const ConfigurationError& error) {
    return error.what();
  }
  return "no error";
}

std::string orderOf(const std::string& text) {
  std::string result;
  for (const ThreadPlan& thread : plan(text)) {
    result += "[" + thread.name + "]";
    for (const ModulePlan& module : thread.modules) result += " " + module.loader->description().name;
  }
  return result;
}

TEST(ModuleGraphTest, sortsProvidersBeforeWhoRequires) {
  EXPECT_EQ(orderOf("GammaFromBeta Gamma\nBetaFromAlpha Beta\nAlphaSource Alpha\n"),
            "[default] AlphaSource BetaFromAlpha GammaFromBeta");
}

TEST(ModuleGraphTest, keepsTheOrderOfLinesWhereTheGraphLeavesItOpen) {
  EXPECT_EQ(orderOf("Thrower\nBetaFromAlpha Beta\nStopper\nAlphaSource Alpha\n"),
            "[default] Thrower Stopper AlphaSource BetaFromAlpha");
  EXPECT_EQ(orderOf("Stopper\nThrower\nAlphaSource Alpha\nBetaFromAlpha Beta\n"),
            "[default] Stopper Thrower AlphaSource BetaFromAlpha");
}

TEST(ModuleGraphTest, usesHasNoEffectOnTheOrder) {
  EXPECT_EQ(orderOf("AlphaFromLastGamma Alpha\nBetaFromAlpha Beta\nGammaFromBeta Gamma\n"),
            "[default] AlphaFromLastGamma BetaFromAlpha GammaFromBeta");
}

TEST(ModuleGraphTest, requiresIfProvidedOrdersOnlyIfProvided) {
  EXPECT_EQ(orderOf("OptionalReader\nAlphaSource Alpha\n"), "[default] AlphaSource OptionalReader");
  EXPECT_EQ(orderOf("OptionalReader\nAlphaSource\n"), "[default] OptionalReader AlphaSource");
}

TEST(ModuleGraphTest, outputsKeepTheOrderOfTheirLines) {
  const auto threads = plan("TwinSource Beta\nOptionalReader\nTwinSource Alpha\n");
  const ModulePlan& twin = threads[0].modules[0];
  ASSERT_EQ(twin.outputs.size(), 2u);
  EXPECT_EQ(twin.outputs[0]->representation->name(), "Beta");
  EXPECT_EQ(twin.outputs[1]->representation->name(), "Alpha");
  EXPECT_EQ(twin.line, 1);
}

TEST(ModuleGraphTest, eachThreadHasItsOwnGraph) {
  EXPECT_EQ(orderOf("[motion 10]\ncognition Alpha\nGammaFromBeta Gamma\nBetaFromAlpha Beta\n"
                    "[cognition 5]\nAlphaSource Alpha\n"),
            "[motion] BetaFromAlpha GammaFromBeta[cognition] AlphaSource");
  const auto threads =
      plan("[a 1]\nAlphaSource Alpha\n[b 2]\na Alpha\nStopper\n[c 3]\nb Alpha\nBetaFromAlpha Beta\n");
  EXPECT_EQ(threads[0].provider("Alpha"), "AlphaSource");
  EXPECT_EQ(threads[1].provider("Alpha"), "a");
  EXPECT_EQ(threads[2].provider("Alpha"), "b");
  EXPECT_EQ(threads[2].provider("Beta"), "BetaFromAlpha");
  EXPECT_EQ(threads[2].provider("Gamma"), "");
}

TEST(ModuleGraphTest, namesAMissingProvider) {
  EXPECT_EQ(errorOf("[cognition 3]\nStopper\nOrphanReader\n"),
            "modules.cfg:3: no provider for representation Orphan required by module OrphanReader in thread "
            "cognition");
}

TEST(ModuleGraphTest, namesWhoCouldProvideWhatIsMissing) {
  EXPECT_EQ(errorOf("AlphaSource Alpha\nGammaFromBeta Gamma\n"),
            "modules.cfg:2: no provider for representation Beta required by module GammaFromBeta in thread "
            "default; "
            "add \"BetaFromAlpha Beta\", \"SelfLoop Beta\" or \"TwinSource Beta\"");
  EXPECT_EQ(
      errorOf("[a 1]\nAlphaSource Alpha\n[b 1]\nBetaFromAlpha Beta\n"),
      "modules.cfg:4: no provider for representation Alpha required by module BetaFromAlpha in thread b; "
      "add \"a Alpha\" to copy it from there");
}

TEST(ModuleGraphTest, namesTwoProviders) {
  EXPECT_EQ(
      errorOf("AlphaSource Alpha\nBetaFromAlpha Beta\nTwinSource Beta\n"),
      "modules.cfg:3: representation Beta is already provided by BetaFromAlpha in thread default (line 2)");
  EXPECT_EQ(
      errorOf("AlphaSource Alpha\nAlphaSource Alpha\n"),
      "modules.cfg:2: representation Alpha is already provided by AlphaSource in thread default (line 1)");
  EXPECT_EQ(errorOf("[a 1]\nAlphaSource Alpha\n[b 1]\na Alpha\nTwinSource Alpha\n"),
            "modules.cfg:5: representation Alpha is already provided by a in thread b (line 4)");
}

TEST(ModuleGraphTest, namesACycleAndItsPath) {
  EXPECT_EQ(errorOf("Stopper\nBetaFromAlpha Beta\nGammaFromBeta Gamma\nAlphaFromGamma Alpha\n"),
            "modules.cfg:2: cycle in thread default: BetaFromAlpha requires Alpha of AlphaFromGamma requires "
            "Gamma of "
            "GammaFromBeta requires Beta of BetaFromAlpha; one of them must be USES");
  EXPECT_EQ(
      errorOf("[main 1]\nSelfLoop Beta\n"),
      "modules.cfg:2: cycle in thread main: SelfLoop requires Beta of SelfLoop; one of them must be USES");
}

TEST(ModuleGraphTest, modulesBehindACycleAreNotBlamed) {
  EXPECT_EQ(
      errorOf("AlphaFromGamma\nGammaFromBeta Gamma\nSelfLoop Beta\n"),
      "modules.cfg:3: cycle in thread default: SelfLoop requires Beta of SelfLoop; one of them must be USES");
}

TEST(ModuleGraphTest, namesUnknownNamesAndTheNearestKnown) {
  EXPECT_EQ(errorOf("AlphaSorce Alpha\n"),
            "modules.cfg:1: unknown module AlphaSorce; did you mean \"AlphaSource\"?");
  EXPECT_EQ(errorOf("\nStoper\n"), "modules.cfg:2: unknown module Stoper; did you mean \"Stopper\"?");
  EXPECT_EQ(errorOf("Nonsense Alpha\n"), "modules.cfg:1: unknown module Nonsense");
  EXPECT_EQ(errorOf("AlphaSource Alhpa\n"),
            "modules.cfg:1: unknown representation Alhpa; did you mean \"Alpha\"?");
  EXPECT_EQ(errorOf("AlphaSource Nonsense\n"), "modules.cfg:1: unknown representation Nonsense");
  EXPECT_EQ(errorOf("[cognition 1]\nAlphaSource Alpha\n[motion 1]\ncogniton Alpha\nBetaFromAlpha Beta\n"),
            "modules.cfg:4: unknown module or thread cogniton; did you mean \"cognition\"?");
}

TEST(ModuleGraphTest, namesAModuleInTwoThreads) {
  EXPECT_EQ(errorOf("[a 1]\nTwinSource Alpha\n[b 1]\nTwinSource Beta\n"),
            "modules.cfg:4: module TwinSource is already in thread a (line 2); a module runs in one thread");
}

TEST(ModuleGraphTest, namesWhatAModuleCannotProvide) {
  EXPECT_EQ(errorOf("TwinSource Gamma\n"),
            "modules.cfg:1: module TwinSource cannot provide Gamma, only Alpha and Beta");
  EXPECT_EQ(errorOf("Stopper Gamma\n"),
            "modules.cfg:1: module Stopper cannot provide Gamma, only be executed");
}

TEST(ModuleGraphTest, namesCopiesThatLeadNowhere) {
  EXPECT_EQ(errorOf("[a 1]\nStopper\n[b 1]\na Alpha\nBetaFromAlpha\n"),
            "modules.cfg:4: no provider for representation Alpha in thread a, from where thread b copies it");
  EXPECT_EQ(
      errorOf("[a 1]\nStopper\nb Alpha\n[b 1]\na Alpha\nBetaFromAlpha\n"),
      "modules.cfg:3: representation Alpha is copied between threads in a circle, and no module provides it");
  EXPECT_EQ(errorOf("[a 1]\nStopper\na Alpha\n"), "modules.cfg:3: thread a cannot copy Alpha from itself");
  EXPECT_EQ(errorOf("[a 1]\nStopper\n[b 1]\na Nonsense\nThrower\n"),
            "modules.cfg:4: unknown representation Nonsense");
}

TEST(ModuleGraphTest, namesThreadsThatAreNone) {
  EXPECT_EQ(errorOf("[Stopper 1]\nThrower\n"), "modules.cfg:1: thread Stopper has the name of a module");
  EXPECT_EQ(errorOf("[a 1]\nAlphaSource Alpha\n[b 1]\na Alpha\n"), "modules.cfg:3: thread b has no modules");
}

}  // namespace
}  // namespace plumbline
