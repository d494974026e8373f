#include "support/ModuleHarness.h"

#include <gtest/gtest.h>

#include "framework/TestModules.h"

namespace plumbline {
namespace {

TEST(ModuleHarnessTest, runsAModuleAlone) {
  test::ModuleHarness<BetaFromAlpha> harness;
  harness.input<Alpha>().value = 4;
  harness.cycle();
  EXPECT_EQ(harness.output<Beta>().value, 40);
  harness.input<Alpha>().value = 5;
  harness.cycle(2);
  EXPECT_EQ(harness.output<Beta>().value, 50);
}

TEST(ModuleHarnessTest, optionalInputsAreThereIfTheTestAskedForThem) {
  calls().clear();
  test::ModuleHarness<OptionalReader> none, both;
  both.input<Alpha>();
  both.input<Beta>();
  none.cycle();
  both.cycle();
  EXPECT_EQ(calls(),
            (std::vector<std::string>{"OptionalReader:execute", "OptionalReader:execute Alpha Beta"}));
}

TEST(ModuleHarnessTest, knowsTheStop) {
  test::ModuleHarness<Stopper> harness;
  harness.cycle(2);
  EXPECT_FALSE(harness.stop().requested());
  harness.cycle();
  EXPECT_EQ(harness.stop().reason(), "three cycles are enough");
}

}  // namespace
}  // namespace plumbline
