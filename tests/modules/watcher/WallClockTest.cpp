#include "modules/watcher/WallClock.h"

#include <gtest/gtest.h>

#include <chrono>
#include <thread>

#include "support/ModuleHarness.h"

namespace plumbline {
namespace {

class WallClockTest : public testing::Test {
protected:
  const FrameInfo& cycle() {
    harness.cycle();
    return frame;
  }
  test::ModuleHarness<WallClock> harness;
  const FrameInfo& frame = harness.output<FrameInfo>();
};

TEST_F(WallClockTest, keepsTheRate) {
  harness.module().rate = 100;
  EXPECT_EQ(cycle().cycleSeconds, 0.01) << "of the first cycle, which has none before it";
  EXPECT_EQ(frame.cycle, 1u);
  for (int i = 0; i < 10; ++i) EXPECT_GT(cycle().cycleSeconds, 0);
  EXPECT_GE(frame.time, 0.0999);
  EXPECT_EQ(frame.cycle, 11u);
}

TEST_F(WallClockTest, aCycleThatComesLateIsNotMadeUpFor) {
  harness.module().rate = 20;
  cycle();
  std::this_thread::sleep_for(std::chrono::milliseconds(110));
  EXPECT_GT(cycle().cycleSeconds, 0.1);
  EXPECT_GT(cycle().cycleSeconds, 0.025) << "no cycle at once behind it, on a busy machine either";
}

}  // namespace
}  // namespace plumbline
