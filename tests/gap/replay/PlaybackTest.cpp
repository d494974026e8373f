#include "gap/replay/Playback.h"

#include <gtest/gtest.h>

#include "../TwoJointArm.h"

namespace plumbline::gap {
namespace {

class PlaybackTest : public ::testing::Test {
protected:
  static std::vector<double> valuesOf(const std::vector<Playback::Shown>& shown) {
    std::vector<double> values;
    for (const auto& [signal, cycle, value] : shown) values.push_back(value);
    return values;
  }

  const Mechanism arm = twoJointArm();
  const Plant plant = nominalPlant(arm);
  const Trial trial = armTrial(arm, 2);
};

TEST_F(PlaybackTest, readingsFallDueOncePerSignalAndCycle) {
  Playback playback(plant, trial, {});
  std::vector<std::size_t> next(2, 0);
  const auto count = [&](const std::vector<Playback::Shown>& shown) {
    for (const auto& [signal, cycle, value] : shown) EXPECT_EQ(cycle, next[signal]++);
  };
  count(playback.settle());
  for (std::size_t k = 0; k < trial.cycles(); ++k) count(playback.play(k));
  EXPECT_EQ(next, std::vector<std::size_t>(2, trial.cycles()));
}

TEST_F(PlaybackTest, aCopyGoesOnByItself) {
  Playback one(plant, trial, {});
  one.settle();
  for (std::size_t k = 0; k < 50; ++k) one.play(k);
  Playback same = one, other = one;
  const std::vector<std::uint8_t> lost(trial.cycles(), 1);
  other.lose(&lost);
  std::vector<double> first, second, third;
  for (std::size_t k = 50; k < 60; ++k) {
    first = valuesOf(one.play(k));
    second = valuesOf(same.play(k));
    third = valuesOf(other.play(k));
    EXPECT_EQ(first, second) << k;
  }
  EXPECT_GT(std::abs(first[0] - third[0]), 0.01);
}

TEST_F(PlaybackTest, jointsThatAreNotPlayedAreNotRead) {
  ReplayOptions options;
  options.joints = {0};
  const Playback playback(plant, trial, options);
  EXPECT_TRUE(playback.reads(0));
  EXPECT_FALSE(playback.reads(1));
}

}  // namespace
}  // namespace plumbline::gap
