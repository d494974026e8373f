// What the method finds in recordings of the two-joint arm whose truth is known.
#include <gtest/gtest.h>

#include <cmath>

#include "../ThreeRecordings.h"
#include "gap/inference/Beam.h"
#include "gap/inference/Posterior.h"
#include "gap/inference/Strengths.h"

namespace plumbline::gap {

TEST(Groups, recordingsAreLeftOutOneByOneAndRepeatsTogether) {
  std::vector<Trial> trials = recordings({});
  trials.push_back(trials[1]);
  trials.back().recording = "again";
  const Groups groups(trials);
  EXPECT_EQ(groups.count(), 3);
  EXPECT_FALSE(groups.stretchesOfOne());
  EXPECT_TRUE(groups.holds(1, 1));
  EXPECT_TRUE(groups.holds(1, 3));
  EXPECT_FALSE(groups.holds(1, 2));
}

TEST(Groups, oneRecordingIsCutIntoStretches) {
  const Groups groups({recordings({}).front()});
  EXPECT_EQ(groups.count(), 4);
  EXPECT_TRUE(groups.stretchesOfOne());
  EXPECT_EQ(groups.groupOf(0, 0), 0);
  EXPECT_EQ(groups.groupOf(0, 399), 3);
}

TEST(Groups, aGroupLeftOutIsGoneAndTheOthersAreNumberedAnew) {
  const Groups groups(recordings({}));
  const Groups two = groups.without(1), one = two.without(0);
  EXPECT_EQ(two.count(), 2);
  EXPECT_FALSE(two.holds(1));
  EXPECT_TRUE(two.holds(1, 2));
  // The one that is left is cut into stretches, of which each can be left out.
  EXPECT_EQ(one.count(), 4);
  EXPECT_TRUE(one.stretchesOfOne());
  EXPECT_TRUE(one.holds(2));
  EXPECT_FALSE(one.holds(0));
  const Groups three = one.without(3);
  EXPECT_EQ(three.count(), 3);
  for (const Cell& cell : three.cells()) EXPECT_LE(cell.to, 300);
}

TEST(Replayer, sameHypothesisSameResidualsWhateverCameBetween) {
  const Mechanism arm = twoJointArm();
  const Groups groups(recordings({}));
  const Explanation one{causeOfArm("coulomb_friction", "elbow", 0.1)},
      other{causeOfArm("servo_gain", "shoulder", 0.7)};
  const Replayer replayer(arm, groups, 1), fresh(arm, groups, 2);
  const Residuals first = replayer.residuals(one);
  const std::size_t replays = replayer.numReplays();
  replayer.residuals(other);
  const Residuals again = replayer.residuals(one), anew = fresh.residuals(one);
  EXPECT_EQ(replayer.numReplays(), 2 * replays);
  for (std::size_t t = 0; t < first.size(); ++t)
    for (std::size_t s = 0; s < first[t].size(); ++s) {
      EXPECT_EQ(first[t][s], again[t][s]);
      EXPECT_EQ(*first[t][s], *anew[t][s]);
    }
}

TEST(CandidateScreening, aKnownCauseGainsMostAndItsStrengthIsPredicted) {
  const Mechanism arm = twoJointArm();
  const Groups groups(recordings({causeOfArm("viscous_friction", "shoulder", 0.15)}));
  const Replayer replayer(arm, groups, 1);
  const Shares shares = sharesOf(groups, replayer.residuals({}));
  const CandidateScreening screening(replayer, shares);
  const std::vector<Proposal> proposals = screening.propose(replayer, {}, shares, 3);
  ASSERT_FALSE(proposals.empty());
  const Cause& first = proposals.front().cause;
  EXPECT_TRUE(first.effect->id == "viscous_friction" || first.effect->id == "servo_damping")
      << describe(first);
  EXPECT_EQ(first.place.at, "shoulder");
  EXPECT_GT(proposals.front().gain, 10);
}

TEST(CandidateScreening, whereNothingIsAboveTheNoiseNothingIsReplayed) {
  const Groups groups(recordings({}));
  const Mechanism arm = twoJointArm();
  const Replayer replayer(arm, groups, 1);
  EXPECT_EQ(CandidateScreening(replayer, sharesOf(groups, replayer.residuals({}))).numStarts(), 0U);
}

TEST(Fit, findsBothValues) {
  const Mechanism arm = twoJointArm();
  const Groups groups(
      recordings({causeOfArm("coulomb_friction", "shoulder", 0.12), causeOfArm("servo_gain", "elbow", 0.7)}));
  const Replayer replayer(arm, groups, 1);
  const Shares shares = sharesOf(groups, replayer.residuals({}));
  const Fitted fitted =
      fit(replayer, shares,
          {causeOfArm("coulomb_friction", "shoulder", 0.05), causeOfArm("servo_gain", "elbow", 0.9)}, 12);
  EXPECT_NEAR(fitted.causes[0].value, 0.12, 0.004);
  EXPECT_NEAR(fitted.causes[1].value, 0.7, 0.01);
}

TEST(Fit, aJointThatSticksIsFittedWhereDerivativesLeadNowhere) {
  // By Gauss-Newton steps alone the first ends at 0.171, the second at 0.35.
  const Mechanism arm = twoJointArm();
  const auto fitted = [&](const char* effect, double truth, double from) {
    const Groups groups(recordings({causeOfArm(effect, "elbow", truth)}));
    const Replayer replayer(arm, groups, 1);
    const Shares shares = sharesOf(groups, replayer.residuals({}));
    return fit(replayer, shares, {causeOfArm(effect, "elbow", from)}, 4).causes[0].value;
  };
  EXPECT_NEAR(fitted("load_stribeck_friction", 0.7, 0.175), 0.7, 0.01);
  EXPECT_NEAR(fitted("stribeck_friction", 0.6, 0.06), 0.6, 0.005);
}

TEST(Score, aGroupLeftOutIsNotFitted) {
  // The third recording has another friction; what is fitted without it is that of the others.
  const Mechanism arm = twoJointArm();
  std::vector<Trial> trials = recordings({causeOfArm("coulomb_friction", "shoulder", 0.1)});
  trials[2] = recordings({causeOfArm("coulomb_friction", "shoulder", 0.2)})[2];
  const Groups groups(trials);
  const Replayer replayer(arm, groups, 1);
  const Shares shares = sharesOf(groups, replayer.residuals({}));
  const Scored scored =
      score(replayer, shares, {causeOfArm("coulomb_friction", "shoulder", 0.12)}, 50, 12, LeaveOut::refit);
  EXPECT_NEAR(scored.without[2][0].value, 0.1, 0.005);
  EXPECT_GT(scored.without[0][0].value, 0.1);
}

TEST(Score, valuesWithoutAGroupAreAtLeastAsLikelyOnTheOthersAsThoseOfAll) {
  // Where a joint sticks, a whole Newton step from there would lead to values that are far less likely.
  const Mechanism arm = twoJointArm();
  const Groups groups(recordings(
      {causeOfArm("load_friction", "elbow", 0.3), causeOfArm("load_stribeck_friction", "elbow", 0.4)}));
  const Replayer replayer(arm, groups, 1);
  const Shares shares = sharesOf(groups, replayer.residuals({}));
  for (const double start : {0.1, 0.2, 0.3, 0.4, 0.5}) {
    const Scored scored = score(
        replayer, shares,
        {causeOfArm("load_friction", "elbow", start), causeOfArm("load_stribeck_friction", "elbow", 0.2)}, 50,
        0);
    for (std::size_t g = 0; g < groups.count(); ++g) {
      std::vector<char> others(groups.count(), 1);
      others[g] = 0;
      EXPECT_GE(densityOn(replayer, shares, scored.without[g], others),
                densityOn(replayer, shares, scored.causes(), others))
          << start << ' ' << g;
    }
  }
}

TEST(Score, aCauseThatIsNotThereCostsItsPrice) {
  EXPECT_NEAR(priceOf(2, 100), 2 * std::log(100.0), 1e-12);
  const Mechanism arm = twoJointArm();
  const Groups groups(recordings({}));
  const Replayer replayer(arm, groups, 1);
  const Shares shares = sharesOf(groups, replayer.residuals({}));
  const Scored none = score(replayer, shares, {}, 50, 6),
               one = score(replayer, shares, {causeOfArm("coulomb_friction", "shoulder", 0.02)}, 50, 6);
  EXPECT_GT(none.score(), one.score());
}

TEST(Score, aSetGainsOverTheNominalModelByItsValuesWithoutEachGroup) {
  // Both count by the mean of the correlation times of what they leave, whatever else was looked at. The
  // truth leaves noise, whose scale is known.
  const Mechanism arm = twoJointArm();
  const Cause truth = causeOfArm("coulomb_friction", "shoulder", 0.15),
              off = causeOfArm("coulomb_friction", "shoulder", 0.4);
  const Groups groups(recordings({truth}));
  const Replayer replayer(arm, groups, 1);
  const Shares slow = sharesOf(groups, replayer.residuals({}));
  Shares shares = sharesOf(groups, replayer.residuals({truth}));
  const Residuals left = replayer.residuals({truth});
  for (std::size_t c = 0; c < shares.size(); ++c) {
    const Cell& cell = groups.cells()[c];
    const double scale = likeliestScale(split(residualsOf(cell, left)).about, cell.noise);
    shares[c] = 2 / (timeOfScale(1 / shares[c], scale, cell.noise) + 1 / slow[c]);
  }
  const std::vector<double> nominal = densities(groups, replayer.residuals({}), shares),
                            right = densities(groups, replayer.residuals({truth}), shares),
                            gains = gainsOf(replayer, {truth}, {{truth}, {off}, {truth}});
  ASSERT_EQ(gains.size(), 3U);
  EXPECT_NEAR(gains[0], right[0] - nominal[0], 1e-9);
  EXPECT_NEAR(gains[2], right[2] - nominal[2], 1e-9);
  EXPECT_LT(gains[1], right[1] - nominal[1]);
  EXPECT_EQ(gainsOf(replayer, {}, {{}, {}, {}}), std::vector<double>(3, 0.0));
}

TEST(Posterior, equalScoresShareAndGroupsThatDisagreeLeaveDoubt) {
  Scored a, b;
  a.gain = b.gain = {-10, -10, -10};
  EXPECT_NEAR(posterior({a, b})[0], 0.5, 1e-9);
  b.gain = {-30, 8, -8};  // -30 in all, as a; which of them wins depends on how groups count
  const double p = posterior({a, b})[0];
  EXPECT_GT(p, 0.2);
  EXPECT_LT(p, 0.8);
  b.gain = {-20, -20, -20};
  EXPECT_GT(posterior({a, b})[0], 0.99);
}

}  // namespace plumbline::gap
