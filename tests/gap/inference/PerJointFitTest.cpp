// All frictions of all joints at once, on recordings of the two-joint arm whose truth is known.
#include "gap/inference/PerJointFit.h"

#include <gtest/gtest.h>

#include <array>

#include "../ThreeMotions.h"
#include "gap/inference/AllJointFit.h"

namespace plumbline::gap {

namespace {

const Explanation& frictionOfBoth() {
  static const Explanation causes{causeOfArm("coulomb_friction", "shoulder", 0.12),
                                  causeOfArm("viscous_friction", "shoulder", 0.1),
                                  causeOfArm("coulomb_friction", "elbow", 0.06)};
  return causes;
}

}  // namespace

TEST(PerJointFit, findsTheValuesOfEachJointAtOnce) {
  const Mechanism arm = twoJointArm();
  const Groups groups(threeMotions(frictionOfBoth()));
  const Replayer replayer(arm, groups, 1);
  static constexpr std::array<std::string_view, 2> ids{"coulomb_friction", "viscous_friction"};
  const PerJoint fitted = fitPerJoint(replayer, perJoint(arm, {}, ids), 12);
  EXPECT_EQ(fitted.parameters, 4);
  EXPECT_NEAR(causeIn(fitted.causes, "coulomb_friction", "shoulder").value, 0.12, 0.006);
  EXPECT_NEAR(causeIn(fitted.causes, "viscous_friction", "shoulder").value, 0.1, 0.01);
  EXPECT_NEAR(causeIn(fitted.causes, "coulomb_friction", "elbow").value, 0.06, 0.006);
  EXPECT_LT(fitted.left, 0.01);
  EXPECT_DOUBLE_EQ(fitted.left, shareLeft(replayer, fitted.causes));
  EXPECT_DOUBLE_EQ(shareLeft(replayer, {}), 1);
}

TEST(PerJointFit, whatTheBaseHasOfTheseEffectsIsWhereTheyStartAndTheRestIsHeld) {
  const Mechanism arm = twoJointArm();
  const Explanation base{causeOfArm("servo_gain", "elbow", 0.8),
                         causeOfArm("coulomb_friction", "elbow", 0.05)};
  static constexpr std::array<std::string_view, 2> ids{"coulomb_friction", "viscous_friction"};
  const PerJoint start = perJoint(arm, base, ids);
  EXPECT_EQ(start.parameters, 4);
  EXPECT_EQ(start.causes.size(), 5);
  EXPECT_EQ(start.causes.front(), base.front());
  EXPECT_DOUBLE_EQ(causeIn(start.causes, "coulomb_friction", "elbow").value, 0.05);
  EXPECT_DOUBLE_EQ(causeIn(start.causes, "coulomb_friction", "shoulder").value, 0);
  const Groups groups(threeMotions(base));
  const PerJoint fitted = fitPerJoint(Replayer(arm, groups, 1), start, 2);
  EXPECT_EQ(fitted.causes.front(), base.front());
}

TEST(PerJointFit, aCauseOfAGroupBeginsInItsJoints) {
  Mechanism arm = twoJointArm();
  arm.groups.push_back({"outer", {1}});
  const Explanation ofGroup{{findEffect("coulomb_friction"), {Site::everywhere, 0, "outer"}, 0.08, 0}};
  static constexpr std::string_view ids[] = {"coulomb_friction"};
  const PerJoint start = perJoint(arm, ofGroup, ids);
  EXPECT_EQ(causeIn(start.causes, "coulomb_friction", "shoulder").value, 0);
  EXPECT_EQ(causeIn(start.causes, "coulomb_friction", "elbow").value, 0.08);
}

TEST(PerJointFit, whatIsNotOfJointsIsRefused) {
  static constexpr std::array<std::string_view, 1> ids{"link_mass"};
  try {
    perJoint(twoJointArm(), {}, ids);
    FAIL() << "link_mass was taken";
  } catch (const std::invalid_argument& error) {
    EXPECT_STREQ(error.what(), "link_mass is no effect of joints");
  }
}

TEST(PerJointFit, aPriorDrawsJointsToWhatTheyHaveInCommon) {
  const Mechanism arm = twoJointArm();
  const Groups groups(threeMotions({causeOfArm("viscous_friction", "shoulder", 0.2)}));
  const Replayer replayer(arm, groups, 1);
  static constexpr std::array<std::string_view, 1> ids{"viscous_friction"};
  const auto apart = [&](const Shrinkage& prior) {
    const Explanation causes = fitPerJoint(replayer, perJoint(arm, {}, ids), 8, prior).causes;
    return causeIn(causes, "viscous_friction", "shoulder").value -
           causeIn(causes, "viscous_friction", "elbow").value;
  };
  const double free = apart({}), weak = apart({.own = 1e-3}), strong = apart({.own = 1});
  EXPECT_NEAR(free, 0.2, 0.02);
  EXPECT_LT(weak, free);
  EXPECT_LT(strong, 0.5 * weak);
  // Both drawn to nominal.
  const Explanation nominal =
      fitPerJoint(replayer, perJoint(arm, {}, ids), 8, {.own = 1e3, .common = 1e3}).causes;
  EXPECT_NEAR(causeIn(nominal, "viscous_friction", "shoulder").value, 0, 0.002);
}

TEST(AllJointFit, saysHowMuchMoreAllValuesClose) {
  const Mechanism arm = twoJointArm();
  const std::vector<Trial> trials = threeMotions(frictionOfBoth());
  const auto leftBy = [&](const Explanation& causes) {
    std::vector<RecordingLeft> left;
    for (const Trial& trial : trials) left.push_back(leftIn(trial, {{0, causes}}));
    return left;
  };
  const std::vector<Explanation> nothing(trials.size());
  const AllJointFit further = fitOfAllJoints(arm, trials, {}, nothing, leftBy({}), {});
  EXPECT_EQ(further.parameters, 22);
  EXPECT_EQ(further.leftOut.size(), 3);
  EXPECT_GT(further.closed, 0.85);
  EXPECT_GT(further.claim.closed, 0.7);
  EXPECT_LT(fitOfAllJoints(arm, trials, {}, nothing, leftBy(frictionOfBoth()), {}).closed, 0.02);
  // What it fitted to all closes as much of another motion.
  Trial other = armTrial(arm, 4, 0.3);
  other = recorded(plantOf(arm, frictionOfBoth()), other, readingNoise, 9);
  EXPECT_GT(leftIn(other, {{0, further.model}}).closed(), 0.85);
  EXPECT_LE(further.model.size(), further.parameters);
}

TEST(AllJointFit, isSaidWhereItIsWorthIt) {
  AllJointFit further;
  further.parameters = 24;
  further.closed = 0.12;
  EXPECT_EQ(further.sentence(),
            "A further 12 % closes by fitting 24 values of all joints at once; not attributable.");
  further.closed = 0.02;
  EXPECT_EQ(further.sentence(), "");
}

TEST(AllJointFit, ofARobotOnItsFeetNothingIsSaid) {
  std::vector<Trial> trials = threeMotions({});
  trials[1].freeBase = true;
  EXPECT_EQ(fitOfAllJoints(twoJointArm(), trials, {}, {}, {}, {}).parameters, 0);
}

}  // namespace plumbline::gap
