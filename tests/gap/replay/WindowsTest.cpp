#include "gap/replay/Windows.h"

#include <gtest/gtest.h>

#include "../TwoJointArm.h"
#include "gap/diagnosis/Noise.h"

namespace plumbline::gap {
namespace {

TEST(WindowsTest, aShortRunStaysWhole) {
  const Trial trial = armTrial(twoJointArm(), 20);
  const std::vector<Trial> windows = windowsOf(trial, 20);
  ASSERT_EQ(windows.size(), 1u);
  EXPECT_EQ(windows[0].time, trial.time);
  EXPECT_EQ(windows[0].name, trial.name);
}

TEST(WindowsTest, aLongRunIsCutEvenly) {
  const Trial trial = armTrial(twoJointArm(), 60);
  const std::vector<Trial> windows = windowsOf(trial, 15);
  ASSERT_EQ(windows.size(), 3u);
  for (std::size_t i = 0; i < 3; ++i) {
    const Trial& window = windows[i];
    // 60 s in three parts, 5 s in the middle of each, after 1.5 s that are played alone.
    const double from = 20.0 * static_cast<double>(i) + 7.5;
    EXPECT_NEAR(window.time.front(), from - 1.5, 0.011);
    EXPECT_NEAR(window.time.back(), from + 5, 0.011);
    ASSERT_EQ(window.command[1].size(), window.cycles());
    ASSERT_EQ(window.signals[1].values.size(), window.cycles());
    for (std::size_t k = 0; k < window.cycles(); ++k) {
      EXPECT_EQ(std::isfinite(window.signals[1].values[k]), window.time[k] > from - 0.005);
      const auto same = static_cast<std::size_t>(std::lround(window.time[k] * 100));
      EXPECT_EQ(window.command[1][k], trial.command[1][same]);
    }
  }
  EXPECT_EQ(windows[1].motion, trial.motion + " (27 s)");
  EXPECT_FALSE(isRepeat(windows[0], windows[1]));
}

TEST(WindowsTest, nothingIsLookedAtTwice) {
  const std::vector<Trial> windows = windowsOf(armTrial(twoJointArm(), 13), 12.9);
  ASSERT_EQ(windows.size(), 2u);
  std::size_t compared = 0;
  for (const Trial& window : windows)
    for (const double value : window.signals[0].values) compared += std::isfinite(value);
  EXPECT_EQ(compared, 1000u);
}

TEST(WindowsTest, severalRunsShareTheTime) {
  const Mechanism arm = twoJointArm();
  const std::vector<Trial> runs{armTrial(arm, 60), armTrial(arm, 20)};
  const auto counts = [&](double most) {
    std::vector<std::size_t> sizes;
    for (const auto& windows : windowsOf(runs, most)) sizes.push_back(windows.size());
    return sizes;
  };
  EXPECT_EQ(counts(80), (std::vector<std::size_t>{1, 1})) << "no more than asked for";
  EXPECT_EQ(counts(40), (std::vector<std::size_t>{6, 2}));
  EXPECT_EQ(counts(1), (std::vector<std::size_t>{1, 1})) << "one of each at least";
}

TEST(WindowsTest, onTheFeetARunStaysWhole) {
  Trial trial = armTrial(twoJointArm(), 60);
  trial.freeBase = true;
  EXPECT_EQ(windowsOf(trial, 15).size(), 1u);
}

TEST(WindowsTest, theRobotForgetsHowAWindowBegan) {
  const Mechanism arm = twoJointArm();
  Plant plant = nominalPlant(arm);
  plant.joints[1].viscous = 0.2;
  // Nothing but sines: where a motor is at its limit, as in steps, an arm forgets later.
  Trial sines = armTrial(arm, 90, 0.1);
  sines.time.resize(3000);
  for (auto& command : sines.command) command.resize(3000);
  for (Signal& signal : sines.signals) signal.values.resize(3000);
  const Trial run = recorded(plant, sines, 0, 1);
  for (const Trial& window : windowsOf(run, 10)) {
    const Prediction played = replay(plant, window);
    double worst = 0;
    for (std::size_t s = 0; s < 2; ++s)
      for (std::size_t k = 0; k < window.cycles(); ++k)
        if (std::isfinite(window.signals[s].values[k]))
          worst = std::max(worst, std::abs(played.values[s][k] - window.signals[s].values[k]));
    EXPECT_LT(worst, 1e-4) << window.name;
  }
}

}  // namespace
}  // namespace plumbline::gap
