#include "gap/run/RunChanges.h"

#include <gtest/gtest.h>

#include "support/Thrown.h"

namespace plumbline::gap {
namespace {

using Recording = Run;  // gtest has a Run of its own in test classes

TEST(RunChangesTest, jointsGetTheRobotsNamesEverywhere) {
  Recording run;
  run.t = {0, 1};
  run.channels = {{"cmd.l_knee", {1, 2}}, {"pos.l_knee", {3, 4}}, {"gyro.x", {5, 6}}, {"pos.hip", {7, 8}}};
  run.servo["l_knee"].kp = 3;
  run.timing["l_knee"].posAt = 0.004;
  apply({jointNames({"l_knee=LKneePitch"}), true}, run);
  EXPECT_EQ(run.channels.at("pos.LKneePitch"), (std::vector{3.0, 4.0}));
  EXPECT_EQ(run.channels.count("cmd.l_knee"), 0U);
  EXPECT_EQ(run.channels.count("gyro.x"), 1U);
  EXPECT_EQ(run.channels.count("pos.hip"), 1U);
  EXPECT_EQ(run.servo.at("LKneePitch").kp, 3);
  EXPECT_EQ(run.timing.at("LKneePitch").posAt, 0.004);
  EXPECT_TRUE(run.linearCommands);
}

TEST(RunChangesTest, twoJointsMayChangeNames) {
  Recording run;
  run.channels = {{"pos.a", {1}}, {"pos.b", {2}}};
  apply({jointNames({"a=b", "b=a"}), {}}, run);
  EXPECT_EQ(run.channels.at("pos.b"), (std::vector{1.0}));
  EXPECT_EQ(run.channels.at("pos.a"), (std::vector{2.0}));
}

TEST(RunChangesTest, wrongWordsAreRefused) {
  EXPECT_EQ(thrownBy([] { jointNames({"knee"}); }),
            "--map knee: write RECORDING=ROBOT, as in l_knee=LKneePitch");
  EXPECT_EQ(thrownBy([] { jointNames({"a=b", "a=c"}); }), "--map a=c: a is there twice");
  EXPECT_EQ(thrownBy([] { jointNames({"a=b", "c=b"}); }), "--map c=b: b is there twice");
  Recording run;
  run.folder = "runs/1";
  run.channels = {{"pos.a", {1}}, {"pos.b", {2}}};
  EXPECT_EQ(thrownBy([&] {
              apply({jointNames({"a=b"}), {}}, run);
            }),
            "runs/1: --map gives pos.b a second time");
}

}  // namespace
}  // namespace plumbline::gap
