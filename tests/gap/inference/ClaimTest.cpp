#include "gap/inference/Claim.h"

#include <gtest/gtest.h>

#include <cmath>

#include "math/Random.h"

namespace plumbline::gap {

TEST(Claim, manyGroupsThatAgreeAreTakenAtTheirWord) {
  const Claim claim = claimOf(std::vector<double>(12, 0.8));
  EXPECT_NEAR(claim.closed, 0.8, 0.03);
  EXPECT_GT(claim.lower, 0.6);
  EXPECT_LT(claim.upper, 0.9);
}

TEST(Claim, fewGroupsClaimLessThanTheyClosedAndSayHowUnsureThatIs) {
  const Claim one = claimOf({0.8}), two = claimOf({0.8, 0.8}), eight = claimOf(std::vector<double>(8, 0.8));
  EXPECT_LT(one.closed, two.closed);
  EXPECT_LT(two.closed, eight.closed);
  EXPECT_LT(eight.closed, 0.8);
  EXPECT_GT(one.upper - one.lower, two.upper - two.lower);
  EXPECT_GT(two.upper - two.lower, eight.upper - eight.lower);
}

// From the mean's normal prior of 1 and the spread's half-normal one of 0.5, integrated on a fine grid.
TEST(Claim, isWhatThePriorAndTheGroupsSayTogether) {
  const Claim one = claimOf({0.8}), three = claimOf({0.3, 0.7, 0.85});
  EXPECT_NEAR(one.closed, 0.601, 0.01);
  EXPECT_NEAR(one.lower, -0.056, 0.03);
  EXPECT_NEAR(one.upper, 0.896, 0.003);
  EXPECT_NEAR(three.closed, 0.440, 0.01);
  EXPECT_NEAR(three.lower, -0.514, 0.03);
  EXPECT_NEAR(three.upper, 0.900, 0.003);
}

TEST(Claim, lessThanAFiftiethLeftIsNoise) {
  EXPECT_NEAR(std::exp(logLeft(0.97)), 0.03, 1e-12);
  EXPECT_NEAR(std::exp(logLeft(0.99)), 0.02, 1e-12);
  EXPECT_NEAR(std::exp(logLeft(1)), 0.02, 1e-12);
}

TEST(Claim, groupsThatDisagreeLeaveAWiderIntervalAndALowerClaim) {
  const Claim alike = claimOf({0.7, 0.7, 0.7}), apart = claimOf({0.3, 0.7, 0.85});
  EXPECT_LT(apart.closed, alike.closed);
  EXPECT_GT(apart.upper - apart.lower, alike.upper - alike.lower);
}

TEST(Claim, aBiasIsAddedToTheLogarithmsOfWhatIsLeft) {
  const Claim plain = claimOf({0.7, 0.7}), corrected = claimOf({0.4, 0.4}, std::log(0.5));
  EXPECT_NEAR(corrected.closed, plain.closed, 1e-12);
  EXPECT_NEAR(corrected.lower, plain.lower, 1e-12);
}

TEST(Claim, whatClosesNothingClaimsAboutNothing) { EXPECT_NEAR(claimOf({0, 0, 0, 0}).closed, 0, 0.15); }

TEST(Claim, anExplanationThatMakesThingsWorseIsSaidTo) {
  EXPECT_LT(claimOf({-0.5, -0.4, -0.6}).closed, -0.2);
}

TEST(Claim, isRightOnAverageAndItsIntervalCoversNineInTen) {
  // Robots whose log share left is drawn from the prior, each with four motions seen and one not.
  Random random(7);
  constexpr int robots = 1000;
  double sum = 0, squares = 0, covered = 0;
  for (int robot = 0; robot < robots; ++robot) {
    const double mean = random.gaussian(), spread = std::abs(0.5 * random.gaussian());
    const auto draw = [&] { return 1 - std::exp(mean + spread * random.gaussian()); };
    const Claim claim = claimOf({draw(), draw(), draw(), draw()});
    const double unseen = draw(), error = claim.closed - unseen;
    sum += error / robots;
    squares += error * error / robots;
    if (unseen >= claim.lower && unseen <= claim.upper) covered += 1.0 / robots;
  }
  // Three standard errors of the mean, and of a share of 0.9.
  EXPECT_NEAR(sum, 0, 3 * std::sqrt(squares / robots));
  EXPECT_NEAR(covered, 0.9, 3 * std::sqrt(0.9 * 0.1 / robots));
}

TEST(Claim, aRecordingWithoutAGapHasNoSay) {
  std::vector<RecordingLeft> left(3);
  for (RecordingLeft& of : left) of.noise = 0.5;
  left[0].before = 2.5, left[0].after = 0.5;   // down to the noise
  left[1].before = 2.5, left[1].after = 1.5;   // half of what is above it
  left[2].before = 0.51, left[2].after = 0.6;  // nothing to close
  EXPECT_EQ(closedPerGroup(left, {0, 1, 2}), (std::vector<double>{1, 0.5}));
  EXPECT_TRUE(closedPerGroup({left[2]}, {0}).empty());
  EXPECT_EQ(claimOf({}).closed, 0);
}

TEST(Claim, theFloorIsWhatRepeatsDifferByOrTheNoiseIfThatIsMore) {
  RecordingLeft left;
  left.before = 2, left.after = 1, left.noise = 0.4, left.floor = 0.5, left.hasFloor = true;
  EXPECT_DOUBLE_EQ(left.closedToNoise(), 1 / 1.5);
  EXPECT_DOUBLE_EQ(left.closed(), 1 / 1.5);
  left.noise = 0.9;  // repeats were rounded alike
  EXPECT_DOUBLE_EQ(left.closedToNoise(), 1 / 1.1);
  EXPECT_DOUBLE_EQ(left.closed(), 1 / 1.5);
  left.hasFloor = false, left.floor = 0;
  EXPECT_DOUBLE_EQ(left.closedToNoise(), 1 / 1.1);
  EXPECT_DOUBLE_EQ(left.closed(), 0.5);
}

TEST(Claim, recordingsOfOneGroupCountOnce) {
  std::vector<RecordingLeft> left(3);
  for (RecordingLeft& of : left) of.before = 1;
  left[0].after = 0.4;
  left[1].after = 0.2;
  left[2].after = 0.5;
  EXPECT_EQ(closedPerGroup(left, {0, 0, 1}), (std::vector<double>{0.7, 0.5}));
}

}  // namespace plumbline::gap
