// Those of tests/gap/inference/SearchOfSetsTest.cpp that take longer.
#include "gap/inference/CandidateScreening.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "gap/ThreeRecordings.h"
#include "gap/inference/Beam.h"

namespace plumbline::gap {

TEST(CandidateScreening, aSecondCauseIsPredictedWithTheFirst) {
  const Mechanism arm = twoJointArm();
  const Cause first = causeOfArm("coulomb_friction", "elbow", 0.1);
  const Groups groups(recordings({first, causeOfArm("bias_force", "shoulder", 0.2)}));
  const Replayer replayer(arm, groups, 1);
  const Shares shares = sharesOf(groups, replayer.residuals({first}));
  const std::vector<Proposal> proposals =
      CandidateScreening(replayer, shares).propose(replayer, {first}, shares, 5);
  const auto right = std::ranges::find_if(proposals, [](const Proposal& proposal) {
    return proposal.cause.effect->id == "bias_force" && proposal.cause.place.at == "shoulder";
  });
  ASSERT_NE(right, proposals.end());
  EXPECT_GT(right->cause.value, 0.1);  // near enough for the fit to come to it
  EXPECT_LT(right->cause.value, 0.4);
}

TEST(CandidateScreening, ofAJointThatSticksFurtherStrengthsAreReplayed) {
  // The starts are 0.1 and 0.4, and what 0.4 changes says little of what 0.85 does.
  const Mechanism arm = twoJointArm();
  const Groups groups(recordings({causeOfArm("load_stribeck_friction", "elbow", 0.85)}));
  const Replayer replayer(arm, groups, 1);
  const Shares shares = sharesOf(groups, replayer.residuals({}));
  const std::vector<Proposal> proposals =
      CandidateScreening(replayer, shares).propose(replayer, {}, shares, 1);
  ASSERT_EQ(proposals.size(), 1U);
  EXPECT_EQ(proposals[0].cause.effect->id, "load_stribeck_friction");
  EXPECT_EQ(proposals[0].cause.place.at, "elbow");
  EXPECT_GT(proposals[0].cause.value, 0.6);
}

TEST(CandidateScreening, aLimitThatIsReachedInAFewMomentsIsProposed) {
  // In each recording a jump and back, at which the elbow's motor falls short for some cycles.
  const Mechanism arm = twoJointArm();
  const Plant weak = plantOf(arm, {causeOfArm("torque_limit", "elbow", 0.55)});
  std::vector<Trial> trials;
  for (const double jump : {0.14, 0.15, 0.17}) {
    Trial trial = armTrial(arm, 6, 0.05);
    for (std::size_t k = 200; k < 400; ++k)
      trial.command[0][k] = trial.command[1][k] = 0;  // instead of steps
    for (std::size_t k = 300; k < 304; ++k) trial.command[1][k] = jump;
    trial.recording = trial.name = "run" + std::to_string(trials.size());
    trials.push_back(recorded(weak, trial, 5e-4, 3 + trials.size()));
  }
  const Groups groups(trials);
  const Replayer replayer(arm, groups, 1);
  const Shares shares = sharesOf(groups, replayer.residuals({}));
  const std::vector<Proposal> proposals =
      CandidateScreening(replayer, shares).propose(replayer, {}, shares, 3);
  EXPECT_TRUE(std::ranges::any_of(proposals, [](const Proposal& proposal) {
    return proposal.cause.effect->id == "torque_limit" && proposal.cause.place.at == "elbow";
  }));
}

TEST(CandidateScreening, servesTheGroupsThatAreLeft) {
  // One screening of all recordings proposes for some of them: the first alone lacks the friction. Left
  // alone, that one is cut into stretches.
  const Mechanism arm = twoJointArm();
  std::vector<Trial> trials = recordings({causeOfArm("viscous_friction", "shoulder", 0.15)});
  trials[0] = recordings({})[0];
  const Groups groups(trials), with = groups.without(0), none = groups.without(2).without(1);
  const Replayer all(arm, groups, 1);
  const CandidateScreening screening(all, sharesOf(groups, all.residuals({})));
  const auto gainIn = [&](const Groups& some) {
    const Replayer replayer(all, some);
    const std::vector<Proposal> proposals =
        screening.propose(replayer, {}, sharesOf(some, replayer.residuals({})), 1);
    return proposals.empty() ? 0 : proposals.front().gain;
  };
  EXPECT_GT(gainIn(with), 10);
  EXPECT_LT(gainIn(none), 5);
}

TEST(CandidateScreening, anEffectInProportionIsPredictedWhicheverWayItGoes) {
  // One of its two starts is played.
  const Mechanism arm = twoJointArm();
  for (const double torque : {-0.15, 0.15}) {
    const Groups groups(recordings({causeOfArm("bias_force", "elbow", torque)}));
    const Replayer replayer(arm, groups, 1);
    const Shares shares = sharesOf(groups, replayer.residuals({}));
    const std::vector<Proposal> proposals =
        CandidateScreening(replayer, shares).propose(replayer, {}, shares, 8);
    const auto found = std::ranges::find_if(proposals, [](const Proposal& proposal) {
      return proposal.cause.effect->id == "bias_force" && proposal.cause.place.at == "elbow";
    });
    ASSERT_NE(found, proposals.end());
    EXPECT_NEAR(found->cause.value, torque, 0.03);
  }
}

TEST(CandidateScreening, aTorqueThatShowsInTheMeanAloneIsProposed) {
  // The mean falls by less than the price of a cause (two recordings, four times the noise); what varies is
  // below the noise already, and less is left of it with the torque.
  const Mechanism arm = twoJointArm();
  const Cause truth = causeOfArm("bias_force", "elbow", 0.02);
  std::vector<Trial> trials = recordings({});
  trials.pop_back();
  for (Trial& trial : trials) trial = recorded(plantOf(arm, {truth}), trial, 0, 1);
  const Groups groups(trials);
  const Replayer replayer(arm, groups, 1);
  const Shares shares = sharesOf(groups, replayer.residuals({}));
  const CandidateScreening screening(replayer, shares);
  const std::vector<Proposal> proposals = screening.propose(replayer, {}, shares, 8);
  const auto found = std::ranges::find_if(proposals, [](const Proposal& proposal) {
    return proposal.cause.effect->id == "bias_force" && proposal.cause.place.at == "elbow";
  });
  ASSERT_NE(found, proposals.end());
  EXPECT_NEAR(found->cause.value, 0.02, 0.005);
  EXPECT_GT(score(replayer, shares, {truth}, screening.numKinds(), 6).score(), 0);
}

}  // namespace plumbline::gap
