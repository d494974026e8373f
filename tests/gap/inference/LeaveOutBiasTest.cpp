#include "gap/inference/LeaveOutBias.h"

#include <gtest/gtest.h>

#include <cmath>

#include "gap/ThreeRecordings.h"
#include "gap/inference/Claim.h"

namespace plumbline::gap {
namespace {

/// Three recordings of an arm whose elbow rubs, and what searches without each of them found.
struct LeaveOutBiasTest : testing::Test {
  const Cause truth = causeOfArm("coulomb_friction", "elbow", 0.15);
  const Groups groups{recordings({truth})};

  static std::vector<FoundWithout> found(const Explanation& a, const Explanation& b, const Explanation& c) {
    return {{a, {}, {}}, {b, {}, {}}, {c, {}, {}}};
  }
};

TEST_F(LeaveOutBiasTest, isNoneWhereEverySearchFindsTheAnswer) {
  const Explanation all{truth};
  EXPECT_EQ(leaveOutBias(groups, all, found(all, all, all)), 0);
}

TEST_F(LeaveOutBiasTest, isWhatTheAnswerLeavesLessThanTheOthersInAllGroups) {
  const Explanation all{truth}, half{causeOfArm("coulomb_friction", "elbow", 0.075)};
  const auto meanLog = [&](const Explanation& causes) {
    double sum = 0;
    const std::vector<RecordingLeft> recordings = leftWithEach(groups, {causes}).front();
    for (const RecordingLeft& left : recordings) sum += logLeft(left.closedToNoise()) / 3;
    return sum;
  };
  const double whole = meanLog(all), part = meanLog(half);
  EXPECT_LT(whole, part);
  EXPECT_NEAR(leaveOutBias(groups, all, found(half, all, {})), whole - (part + whole + 0) / 3, 1e-9);
}

TEST_F(LeaveOutBiasTest, isNoneWithoutSearches) { EXPECT_EQ(leaveOutBias(groups, {truth}, {}), 0); }

}  // namespace
}  // namespace plumbline::gap
