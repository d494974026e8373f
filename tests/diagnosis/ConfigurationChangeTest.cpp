#include "gap/diagnosis/ConfigurationChange.h"

#include <gtest/gtest.h>

#include "gap/TwoJointArm.h"

namespace plumbline::gap {
namespace {

using Names = std::vector<std::string>;

class ConfigurationChangeTest : public ::testing::Test {
protected:
  /// Recordings "monday" in two windows, "tuesday" and "slow", with these causes; "tuesday" without the
  /// first of them where it differs.
  Evidence recordings(const Explanation& causes, bool differs) const {
    std::vector<Trial> trials;
    for (const char* day : {"monday", "monday", "tuesday", "slow"}) {
      const bool without = differs && *day == 't';
      Trial trial = armTrial(arm, 3, *day == 's' ? 0.02 : 0.4 + 0.02 * static_cast<double>(trials.size()));
      trial.recording = day;
      trial.motion += std::to_string(trials.size());
      const Explanation there(causes.begin() + (without ? 1 : 0), causes.end());
      trials.push_back(recorded(plantOf(arm, there), trial, 5e-4, trials.size() + 1));
    }
    return Evidence(trials);
  }
  static Explanation foundIn(const Evidence& evidence, const Explanation& base) {
    Evaluator evaluator(arm, evidence);
    evaluator.setBase(base);
    return inactiveWhereNotSet(evaluator, 1);
  }

  static inline const Mechanism arm = twoJointArm();
  const Explanation truth = {causeOfArm("acceleration_limit", "elbow", 20),
                             causeOfArm("coulomb_friction", "elbow", 0.08)};
};

TEST_F(ConfigurationChangeTest, theRecordingThatRanWithoutItIsNamedAndValuesAreFittedAnew) {
  const Evidence evidence = recordings(truth, true);
  Explanation off = truth;
  off[0].value = 30;  // between both, as a fit to all recordings has it
  off[1].value = 0.1;
  const Explanation found = foundIn(evidence, off);
  ASSERT_EQ(found.size(), 2u);
  EXPECT_EQ(found[0].inactiveIn, Names{"tuesday"});
  EXPECT_NEAR(found[0].value, 20, 0.5);
  EXPECT_EQ(found[1].inactiveIn, Names{});
  EXPECT_NEAR(found[1].value, 0.08, 0.004);
}

TEST_F(ConfigurationChangeTest, whatIsInEveryRecordingStaysAsItIs) {
  EXPECT_EQ(foundIn(recordings(truth, false), truth), truth);
}

TEST_F(ConfigurationChangeTest, aRecordingThatShowsItAfterAllIsTakenInAgain) {
  Explanation base = truth;
  base[0].inactiveIn = {"monday", "tuesday"};
  const Explanation found = foundIn(recordings(truth, true), base);
  EXPECT_EQ(found[0].inactiveIn, Names{"tuesday"});
}

TEST_F(ConfigurationChangeTest, oneSettingThatSomeRecordingsHadIsFoundFromNothing) {
  const auto from = [&](const Explanation& causes, bool differs) {
    const Evidence evidence = recordings(causes, differs);
    return configurationOfSome(Evaluator(arm, evidence), 1);
  };
  const Explanation found = from({truth[0]}, true);
  ASSERT_EQ(found.size(), 1u);
  EXPECT_EQ(found[0].effect->id, "acceleration_limit");
  EXPECT_EQ(found[0].inactiveIn, Names{"tuesday"});
  EXPECT_NEAR(found[0].value, 20, 0.5);
  EXPECT_TRUE(from({truth[0]}, false).empty());
}

TEST_F(ConfigurationChangeTest, frictionIsNoSettingAndACauseThatNoRecordingShowsStays) {
  const Explanation friction = {causeOfArm("coulomb_friction", "elbow", 0.08)};
  const Evidence evidence = recordings(friction, true);
  EXPECT_EQ(foundIn(evidence, friction), friction);
  const Explanation limit = {causeOfArm("acceleration_limit", "elbow", 20)};
  EXPECT_EQ(foundIn(recordings({friction[0]}, false), limit), limit);
}

}  // namespace
}  // namespace plumbline::gap
