#include "modules/motion/DeadMotion.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "support/ModuleHarness.h"

namespace plumbline {
namespace {

TEST(DeadMotion, everyJointIsSlackAndAnyMotionMayFollow) {
  test::ModuleHarness<DeadMotion> harness;
  const DeadMotionOutput& output = harness.output<DeadMotionOutput>();
  harness.cycle(2);
  EXPECT_TRUE(std::ranges::all_of(output.targets.set, [](bool set) { return set; }));
  EXPECT_TRUE(std::ranges::all_of(output.targets.stiffness, [](double stiffness) { return stiffness == 0; }));
  EXPECT_TRUE(output.finished);
  EXPECT_FALSE(output.endsByItself);
  EXPECT_EQ(output.motion, Motion::dead);
}

}  // namespace
}  // namespace plumbline
