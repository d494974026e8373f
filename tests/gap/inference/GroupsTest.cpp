#include "gap/inference/Groups.h"

#include <gtest/gtest.h>

#include <string>

#include "../LegOnItsFoot.h"

namespace plumbline::gap {

namespace {

/// Two hung up, two on the foot, in this order: hung, standing, hung, standing.
std::vector<Trial> fourTrials() {
  std::vector<Trial> trials;
  for (int i = 0; i < 4; ++i) {
    Trial trial = legTrial(i % 2 == 1);
    trial.recording = trial.name = "run" + std::to_string(i);
    for (double& command : trial.command[0]) command *= 1 - 0.1 * i;
    trials.push_back(recorded(plantOf(legOnItsFoot(), {}), trial, 5e-4, 3 + trials.size()));
  }
  return trials;
}

}  // namespace

TEST(Groups, thoseWithAFixedBaseAsOne) {
  const Groups groups(fourTrials()), other = groups.withFixedBaseAsOne();
  ASSERT_EQ(groups.count(), 4U);
  ASSERT_EQ(other.count(), 3U);
  const std::size_t expected[] = {0, 1, 0, 2};
  for (std::size_t t = 0; t < 4; ++t) {
    EXPECT_EQ(other.groupOf(t, 0), expected[t]);
    EXPECT_TRUE(other.holds(expected[t], t));
  }
  EXPECT_EQ(other.cells().size(), groups.cells().size());
}

// Segments of long recordings, 10 s each: of two recordings all that is needed is half a minute, of each.
TEST(Groups, someOfLongRecordingsIsEnoughAndEachRecordingHasASay) {
  const auto cut = [](int recordings, int segments) {
    std::vector<Trial> trials;
    for (int r = 0; r < recordings; ++r)
      for (int s = 0; s < segments; ++s) {
        Trial trial = armTrial(twoJointArm(), 10, 0.5 - 0.05 * r);
        trial.recording = trial.name = "run" + std::to_string(r);
        trials.push_back(recorded(nominalPlant(*trial.robot), trial, 5e-4, 3 + trials.size()));
      }
    return trials;
  };
  const auto takenOf = [&](int recordings, int segments) {
    const std::vector<char> taken = enoughTrials(Groups(cut(recordings, segments)));
    std::vector<int> perRecording(static_cast<std::size_t>(recordings), 0);
    for (std::size_t t = 0; t < taken.size(); ++t)
      perRecording[t / static_cast<std::size_t>(segments)] += taken[t];
    return perRecording;
  };
  EXPECT_EQ(takenOf(2, 3), (std::vector<int>{2, 2}));
  EXPECT_EQ(takenOf(5, 2), (std::vector<int>(5, 1))) << "each has its first";
  EXPECT_EQ(takenOf(2, 1), (std::vector<int>{1, 1})) << "less than that is all taken";
}

TEST(Groups, numbersStayInOrderWhereOneIsLeftOut) {
  const Groups without = Groups(fourTrials()).without(1);
  ASSERT_EQ(without.count(), 3U);
  EXPECT_EQ(without.groupOf(0, 0), 0U);
  EXPECT_EQ(without.groupOf(2, 0), 1U);
  EXPECT_EQ(without.groupOf(3, 0), 2U);
  EXPECT_FALSE(without.holds(1));
}

}  // namespace plumbline::gap
