#include "gap/blind/ScoreJudge.h"

#include <gtest/gtest.h>

#include "gap/blind/HandMadeCases.h"
#include "robot/MechanismFile.h"

namespace plumbline::gap {
namespace {

const Mechanism robot = twoHips();
const BlindJudge judge(robot);

TEST(BlindJudge, JointsOfOneMotorAreOnePlaceAndLinksAreNot) {
  EXPECT_TRUE(judge.same({"backlash", "LHip", "", 1, {}}, named("backlash", "RHip", 1, 1)));
  EXPECT_TRUE(judge.same({"backlash", "RHip", "", 1, {}}, named("backlash", "LHip", 1, 1)));
  EXPECT_FALSE(judge.same({"backlash", "LHip", "", 1, {}}, named("backlash", "Knee", 1, 1)));
  EXPECT_FALSE(judge.same({"backlash", "LHip", "", 1, {}}, named("dead_band", "LHip", 1, 1)));
  // Links that happen to be called like the joints.
  EXPECT_FALSE(judge.same({"link_mass", "LHip", "", 1, {}}, named("link_mass", "RHip", 1, 1)));
  EXPECT_FALSE(judge.same({"command_delay", "*", "", 1, {}}, named("command_delay", "LHip", 1, 1)));
  const Mechanism pendulum = findMechanism("xl330_pendulum");
  EXPECT_TRUE(
      BlindJudge(pendulum).same({"command_delay", "*", "", 1, {}}, named("command_delay", "pendulum", 1, 1)));
}

TEST(BlindJudge, AxisIsPartOfThePlace) {
  const BlindEffect shifted{"com_offset", "Thigh", "y", 0.02, {}};
  NamedCause cause{"com_offset", "Thigh", "y", 0.02, 1};
  EXPECT_TRUE(judge.same(shifted, cause));
  cause.axis = "x";
  EXPECT_FALSE(judge.same(shifted, cause));
}

BlindCase play() { return caseOf(BlindKind::single, {{"backlash", "Knee", "", 1, {}}}); }

TEST(BlindJudge, FourthIsNotAmongThree) {
  const std::vector<NamedCause> rivals = {{"dead_band", "Knee", "", 1, 0.3},
                                          {"servo_gain", "Knee", "", 1, 0.2},
                                          {"backlash", "Knee", "", 1, 0.1}};
  EXPECT_FALSE(judge.amongThree(play(), answer("effect", {named("bias_force", "Knee", 1, 0.4, rivals)})));
}

TEST(BlindJudge, CauseNamedTwiceTakesOnePlaceAmongThree) {
  const std::vector<NamedCause> rivals = {{"dead_band", "Knee", "", 1, 0.3},
                                          {"backlash", "Knee", "", 1, 0.1}};
  const auto named2 =
      answer("effect", {named("bias_force", "Knee", 1, 0.4, rivals), named("dead_band", "Knee", 1, 0.3)});
  EXPECT_TRUE(judge.amongThree(play(), named2));
}

TEST(BlindJudge, OnlyTheVerdictEffectNames) {
  for (const char* verdict : {"unknown", "none", ""}) {
    const BlindAnswer a = answer(verdict, {named("backlash", "Knee", 1, 0.9)});
    EXPECT_FALSE(judge.first(play(), a));
    EXPECT_FALSE(judge.amongThree(play(), a));
    EXPECT_FALSE(judge.placeFirst(play(), a));
    EXPECT_FALSE(judge.right(play(), a));
  }
  EXPECT_FALSE(judge.first(play(), answer("effect")));
}

TEST(BlindJudge, SetF1CountsEachNameOnce) {
  const BlindCase two =
      caseOf(BlindKind::mixture, {{"backlash", "LHip", "", 1, {}}, {"dead_band", "Knee", "", 1, {}}});
  const auto left = named("backlash", "LHip", 1, 1), right = named("backlash", "RHip", 1, 1),
             band = named("dead_band", "Knee", 1, 1);
  EXPECT_DOUBLE_EQ(judge.setF1(two, answer("effect", {left, band})), 1);
  EXPECT_DOUBLE_EQ(judge.setF1(two, answer("effect", {left})), 2.0 / 3);
  // Both hips are one effect and one too many.
  EXPECT_DOUBLE_EQ(judge.setF1(two, answer("effect", {left, right})), 0.5);
  EXPECT_DOUBLE_EQ(judge.setF1(two, answer("effect", {left, right, band})), 0.8);
  // One name does not stand for two effects of one motor.
  const BlindCase hips =
      caseOf(BlindKind::mixture, {{"backlash", "LHip", "", 1, {}}, {"backlash", "RHip", "", 1, {}}});
  EXPECT_DOUBLE_EQ(judge.setF1(hips, answer("effect", {left})), 2.0 / 3);
}

TEST(BlindJudge, MixtureIsRightWithBothAndNoThird) {
  const BlindCase two =
      caseOf(BlindKind::mixture, {{"backlash", "LHip", "", 1, {}}, {"dead_band", "Knee", "", 1, {}}});
  const auto play = named("backlash", "LHip", 1, 1), band = named("dead_band", "Knee", 1, 1);
  EXPECT_TRUE(judge.right(two, answer("effect", {band, play})));
  EXPECT_FALSE(judge.right(two, answer("effect", {band})));
  EXPECT_FALSE(judge.right(two, answer("effect", {band, play, named("bias_force", "Knee", 1, 1)})));
  EXPECT_TRUE(judge.right(caseOf(BlindKind::none, {}), answer("none")));
  EXPECT_FALSE(judge.right(caseOf(BlindKind::none, {}), answer("")));
}

}  // namespace
}  // namespace plumbline::gap
