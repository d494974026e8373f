#include "gap/diagnosis/LossDecoder.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "../TwoJointArm.h"

namespace plumbline::gap {
namespace {

/// A recording of 2 s of sines, in which a loss shows at once, that lost these cycles' commands.
class LossDecoderTest : public ::testing::Test {
protected:
  static std::vector<std::uint8_t> decoded(const Trial& trial, const std::vector<std::uint8_t>& lost,
                                           double price) {
    const Mechanism arm = twoJointArm();
    ReplayOptions options;
    options.lostCycles = &lost;
    const Evidence evidence{{recorded(nominalPlant(arm), trial, 2e-5, 7, options)}};
    return decodeLosses(nominalPlant(arm), evidence, 0, price, 6);
  }

  Trial trial = armTrial(twoJointArm(), 6);
  std::vector<std::uint8_t> lost = std::vector<std::uint8_t>(600, 0);
};

TEST_F(LossDecoderTest, aSingleLossAndARunOfFive) {
  for (const std::size_t k : {60, 100, 101, 102, 103, 104, 150, 152}) lost[k] = 1;
  const std::vector<std::uint8_t> found = decoded(trial, lost, 14);
  EXPECT_TRUE(std::equal(lost.begin(), lost.begin() + 200, found.begin()));
}

TEST_F(LossDecoderTest, aLossOfACommandThatStayedTheSameIsNone) {
  lost[230] = 1;  // between two steps
  EXPECT_EQ(std::ranges::count(decoded(trial, lost, 14), 1), 0);
}

TEST_F(LossDecoderTest, ofAJointThatWasNeverCommandedNothingIsLost) {
  for (const std::size_t k : {60, 100, 101}) lost[k] = 1;
  trial.command[1].clear();
  trial.followed.resize(2);
  for (const double time : trial.time)
    trial.followed[1].push_back(0.3 * std::sin(9 * time));  // moved by hand
  // What the hand does in each cycle is no command that could be lost.
  EXPECT_LE(std::ranges::count(decoded(trial, lost, 14), 1), 6);
}

TEST_F(LossDecoderTest, noLossIsWorthMoreThanItExplains) {
  lost[60] = lost[100] = 1;
  EXPECT_EQ(std::ranges::count(decoded(trial, lost, 1e9), 1), 0);
}

}  // namespace
}  // namespace plumbline::gap
