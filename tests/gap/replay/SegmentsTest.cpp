#include "gap/replay/Segments.h"

#include <gtest/gtest.h>

#include "../TwoJointArm.h"
#include "gap/diagnosis/Noise.h"

namespace plumbline::gap {
namespace {

TEST(Segments, aShortRunStaysWhole) {
  const Trial trial = armTrial(twoJointArm(), 20);
  const std::vector<Trial> segments = segmentsOf(trial, 20);
  ASSERT_EQ(segments.size(), 1u);
  EXPECT_EQ(segments[0].time, trial.time);
  EXPECT_EQ(segments[0].name, trial.name);
}

TEST(Segments, aLongRunIsCutEvenly) {
  const Trial trial = armTrial(twoJointArm(), 60);
  const std::vector<Trial> segments = segmentsOf(trial, 15);
  ASSERT_EQ(segments.size(), 3u);
  for (std::size_t i = 0; i < 3; ++i) {
    const Trial& segment = segments[i];
    // 60 s in three parts, 5 s in the middle of each, after 1.5 s that are played alone.
    const double from = 20.0 * static_cast<double>(i) + 7.5;
    EXPECT_NEAR(segment.time.front(), from - 1.5, 0.011);
    EXPECT_NEAR(segment.time.back(), from + 5, 0.011);
    ASSERT_EQ(segment.command[1].size(), segment.cycles());
    ASSERT_EQ(segment.signals[1].values.size(), segment.cycles());
    for (std::size_t k = 0; k < segment.cycles(); ++k) {
      EXPECT_EQ(std::isfinite(segment.signals[1].values[k]), segment.time[k] > from - 0.005);
      const auto same = static_cast<std::size_t>(std::lround(segment.time[k] * 100));
      EXPECT_EQ(segment.command[1][k], trial.command[1][same]);
    }
  }
  EXPECT_EQ(segments[1].motion, trial.motion + " (27 s)");
  EXPECT_FALSE(isRepeat(segments[0], segments[1]));
}

TEST(Segments, nothingIsLookedAtTwice) {
  const std::vector<Trial> segments = segmentsOf(armTrial(twoJointArm(), 13), 12.9);
  ASSERT_EQ(segments.size(), 2u);
  std::size_t compared = 0;
  for (const Trial& segment : segments)
    for (const double value : segment.signals[0].values) compared += std::isfinite(value);
  EXPECT_EQ(compared, 1000u);
}

TEST(Segments, severalRunsShareTheTime) {
  const Mechanism arm = twoJointArm();
  const std::vector<Trial> runs{armTrial(arm, 60), armTrial(arm, 20)};
  const auto counts = [&](double most) {
    std::vector<std::size_t> sizes;
    for (const auto& segments : segmentsOf(runs, most)) sizes.push_back(segments.size());
    return sizes;
  };
  EXPECT_EQ(counts(80), (std::vector<std::size_t>{1, 1})) << "no more than asked for";
  EXPECT_EQ(counts(40), (std::vector<std::size_t>{6, 2}));
  EXPECT_EQ(counts(1), (std::vector<std::size_t>{1, 1})) << "one of each at least";
}

TEST(Segments, onTheFeetARunStaysWhole) {
  Trial trial = armTrial(twoJointArm(), 60);
  trial.freeBase = true;
  EXPECT_EQ(segmentsOf(trial, 15).size(), 1u);
}

TEST(Segments, theRobotForgetsHowASegmentBegan) {
  const Mechanism arm = twoJointArm();
  Plant plant = nominalPlant(arm);
  plant.joints[1].viscous = 0.2;
  // Nothing but sines: where a motor is at its limit, as in steps, an arm forgets later.
  Trial sines = armTrial(arm, 90, 0.1);
  sines.time.resize(3000);
  for (auto& command : sines.command) command.resize(3000);
  for (Signal& signal : sines.signals) signal.values.resize(3000);
  const Trial run = recorded(plant, sines, 0, 1);
  for (const Trial& segment : segmentsOf(run, 10)) {
    const Prediction played = replay(plant, segment);
    double worst = 0;
    for (std::size_t s = 0; s < 2; ++s)
      for (std::size_t k = 0; k < segment.cycles(); ++k)
        if (std::isfinite(segment.signals[s].values[k]))
          worst = std::max(worst, std::abs(played.values[s][k] - segment.signals[s].values[k]));
    EXPECT_LT(worst, 1e-4) << segment.name;
  }
}

}  // namespace
}  // namespace plumbline::gap
