#include "gap/inference/Interval.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "../ThreeRecordings.h"

namespace plumbline::gap {
namespace {

/// Interval of friction at the shoulder, fitted alone to the arm with these causes; the value it was fitted
/// to.
struct Found {
  Bounds interval;
  double value;
  double width() const { return std::log(interval.upper / interval.lower); }
  bool covers(double truth) const { return interval.lower <= truth && truth <= interval.upper; }
};

constexpr double friction = 0.15;  // [N m s/rad]

Found shoulderFriction(Explanation others) {
  const Cause cause = causeOfArm("viscous_friction", "shoulder", friction);
  others.push_back(cause);
  const Mechanism arm = twoJointArm();
  const Groups groups(recordings(others));
  const Replayer replayer(arm, groups, 1);
  const Scored scored = score(replayer, sharesOf(groups, replayer.residuals({cause})), {cause}, 20, 12);
  return {intervalsOf(replayer, scored).front(), scored.causes().front().value};
}

}  // namespace

TEST(Interval, isNarrowWhereTheModelLacksNothing) {
  const Found found = shoulderFriction({});
  EXPECT_TRUE(found.covers(friction)) << found.interval.lower << " " << found.interval.upper;
  EXPECT_LT(found.width(), 0.02);
}

TEST(Interval, holdsTheTruthWhereTheModelLacksSomething) {
  const double alone = shoulderFriction({}).width();
  for (const Cause& lacking :
       {causeOfArm("servo_gain", "shoulder", 0.9), causeOfArm("command_delay", "shoulder", 0.004),
        causeOfArm("bias_force", "shoulder", 0.1)}) {
    const Found found = shoulderFriction({lacking});
    EXPECT_TRUE(found.covers(friction)) << describe(lacking) << ": " << found.value << " ["
                                        << found.interval.lower << ", " << found.interval.upper << "]";
    EXPECT_GT(found.width(), 2 * alone) << describe(lacking);
    EXPECT_LT(found.width(), 1.5) << describe(lacking);
  }
}

TEST(Interval, endsWhereTheDensityHasFallenByHalfTheQuantileOfChiSquare) {
  const Cause cause = causeOfArm("viscous_friction", "shoulder", friction);
  const Mechanism arm = twoJointArm();
  const Groups groups(recordings({cause}));
  const Replayer replayer(arm, groups, 1);
  Scored scored = score(replayer, sharesOf(groups, replayer.residuals({cause})), {cause}, 20, 12);
  std::ranges::fill(scored.without, scored.causes());  // as if the groups agreed
  const Bounds interval = intervalsOf(replayer, scored).front();
  const Shares shares = sharesOf(groups, replayer.residuals(scored.causes()));
  for (const double end : {interval.lower, interval.upper}) {
    const Explanation there{causeOfArm("viscous_friction", "shoulder", end)};
    const double fall = densityOn(replayer, shares, scored.causes()) - densityOn(replayer, shares, there);
    // 3.84 / 2, and the end is known to a tenth.
    EXPECT_GT(fall, 1.92 / 1.21) << end;
    EXPECT_LT(fall, 1.92 * 1.21) << end;
  }
}

TEST(Interval, ofAValueThatNothingShowsEndsAtTheMost) {
  // 1.96 times a standard deviation of 2 in the logarithm; a friction that is smaller is none at all.
  const double value = 4e-6;
  const Mechanism arm = twoJointArm();
  const Groups groups(recordings({}));
  const Replayer replayer(arm, groups, 1);
  Scored scored;
  scored.fitted.causes = {causeOfArm("viscous_friction", "shoulder", value)};
  scored.without.assign(groups.count(), scored.causes());
  EXPECT_NEAR(std::log(intervalsOf(replayer, scored).front().upper / value), 1.96 * 2, 0.01);
}

TEST(Interval, thereIsNoneWithoutCauses) {
  const Mechanism arm = twoJointArm();
  const Groups groups(recordings({}));
  EXPECT_TRUE(intervalsOf(Replayer(arm, groups, 1), Scored{}).empty());
}

}  // namespace plumbline::gap
