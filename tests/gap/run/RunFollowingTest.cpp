#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "PendulumRun.h"

namespace plumbline::gap {
namespace {

// Two motions that have nothing in common, over whole numbers of their periods.
double one(double t) { return std::sin(2 * std::numbers::pi * 0.5 * t); }
double another(double t) { return std::sin(2 * std::numbers::pi * 0.9 * t); }
double mixed(double t, double share) { return share * one(t) + std::sqrt(1 - share * share) * another(t); }

/// A joint that is commanded to swing so far, and swings so far, in part as commanded.
Run following(double commanded, double moved, double share) {
  return pendulumRun([=](double t) { return commanded * one(t); },
                     [=](double t) { return moved * mixed(t, share); });
}

TEST(RunFollowing, aCommandIsInDegreesWhereItsJointMovesAlikeAndSoMuchLess) {
  const std::string inDegrees = "; is it in degrees?)";
  EXPECT_EQ(
      saidOf(following(1.5, 1.5 / degree, 0.65)),
      "refused: r: no usable cmd column is left (cmd.pendulum: it moves 57.3 times as far as pos.pendulum; "
      "is it in degrees?)");
  EXPECT_NE(saidOf(following(1.5, 1.25 * 1.5 / degree, 1)).find(inDegrees), std::string::npos);
  EXPECT_EQ(saidOf(following(1.5, 1.35 * 1.5 / degree, 1)), "");
  EXPECT_EQ(saidOf(following(1.5, 1.5 / degree, 0.5)),
            "r: pos.pendulum: it does not follow cmd.pendulum; a stuck joint, or another one's sensor\n");
}

TEST(RunFollowing, aPositionIsInDegreesWhereItMovesAsCommandedAndSoMuchMore) {
  EXPECT_EQ(
      saidOf(following(0.038, 0.038 * degree, 0.7)),
      "refused: r: no usable pos column is left (pos.pendulum: it moves 57.3 times as far as cmd.pendulum; "
      "is it in degrees?)");
  EXPECT_NE(saidOf(following(0.036, 1.25 * 0.036 * degree, 1)).find("; is it in degrees?)"),
            std::string::npos);
  EXPECT_EQ(saidOf(following(0.04, 1.35 * 0.04 * degree, 1)),
            "r: pos.pendulum: it moves 77.35 times as far as cmd.pendulum; check its unit\n");
  EXPECT_EQ(saidOf(following(0.038, 0.038 * degree, 0.5)),
            "r: pos.pendulum: it moves 57.3 times as far as cmd.pendulum; check its unit\n");
}

TEST(RunFollowing, aCommandWasDividedByAThousandWhereItsJointFollowsAThousandTimesAsFar) {
  EXPECT_EQ(
      saidOf(following(0.002, 2, 0.7)),
      "refused: r: no usable cmd column is left (cmd.pendulum: pos.pendulum moves 1000 times as far; was it "
      "divided by a thousand?)");
  EXPECT_NE(saidOf(following(0.002, 2.5, 1)).find("divided by a thousand?"), std::string::npos);
  EXPECT_EQ(saidOf(following(0.002, 2, 0.5)), "");
  EXPECT_EQ(saidOf(following(0.002, 2.7, 1)), "");
}

TEST(RunFollowing, aJointThatMovesAgainstItsCommandIsLeftOut) {
  EXPECT_EQ(saidOf(following(0.5, 0.5, -0.75)), "");
  EXPECT_EQ(saidOf(following(0.5, 0.5, -0.85)),
            "refused: r: no usable pos column is left (pos.pendulum: it moves against cmd.pendulum; is its "
            "sign turned "
            "round?)");
}

TEST(RunFollowing, aCommandThatHardlyMovesIsHeldAgainstNothing) {
  EXPECT_EQ(saidOf(following(0.025, 0.025, -0.85)), "");
  EXPECT_NE(saidOf(following(0.03, 0.03, -0.85)), "");
}

TEST(RunFollowing, howFarAJointMayBeBeyondItsLimits) {
  // The rig turns to 3.14159 rad both ways.
  const auto reaching = [](double most) {
    return saidOf(pendulumRun([=](double t) { return 3 * one(t); }, [=](double t) { return most * one(t); }));
  };
  EXPECT_EQ(reaching(3.18), "");
  EXPECT_EQ(reaching(3.2), "r: pos.pendulum: it goes 0.05841 rad beyond the joint's limits\n");
  const std::string farther = reaching(3.55);
  EXPECT_NE(farther.find("it goes 0.4084 rad beyond the joint's limits, but its command never is; kept"),
            std::string::npos)
      << farther;
}

TEST(RunFollowing, aJointThatJumpsBeyondItsLimitsDidNotFallThere) {
  // It follows its command, and is 0.4 rad beyond the limit in two samples; the rig's motor turns 19.45
  // rad/s.
  const auto jumping = [](double way) {
    gap::Run run = pendulumRun([](double t) { return 2.9 * one(t); }, [](double t) { return 2.9 * one(t); });
    std::vector<double>& pos = run.channels["pos.pendulum"];
    pos[51] = 3.55, pos[50] = pos[52] = 3.55 - way;
    pos[49] = pos[53] = 3.55 - 1.9 * way;
    return saidOf(run);
  };
  EXPECT_NE(jumping(0.55).find("kept, because the joint follows its command"), std::string::npos);
  EXPECT_NE(jumping(0.625).find("kept, because"), std::string::npos) << "three times as fast, and 0.05 rad";
  EXPECT_EQ(jumping(0.64).find("kept, because"), std::string::npos);
  EXPECT_NE(jumping(0.75).find("no usable pos column is left (pos.pendulum: it reaches 3.55"),
            std::string::npos);
}

TEST(RunFollowing, aJointIsSeenToFollowInFiftySamplesOfLargeCommandsAtLeast) {
  // Swings out once, for so many samples, and farther than the limit; the command is small else.
  const auto swingingOut = [](int samples, double rest) {
    const auto out = [=](double t, double size) {
      const double i = 100 * t - 200;
      return i > 0 && i < samples + 1 ? size * std::sin(std::numbers::pi * i / (samples + 1)) : rest;
    };
    return saidOf(pendulumRun([=](double t) { return out(t, 2.9); }, [=](double t) { return out(t, 3.55); }));
  };
  EXPECT_NE(swingingOut(60, 0).find("kept, because"), std::string::npos);
  EXPECT_EQ(swingingOut(40, 0).find("kept, because"), std::string::npos);
  EXPECT_EQ(swingingOut(40, 0.045).find("kept, because"), std::string::npos) << "2.6 degrees are small";
  EXPECT_NE(swingingOut(40, 0.06).find("kept, because"), std::string::npos);
}

/// A joint that follows, whose recorded speed is so many times its speed, in part.
std::string withSpeed(double times, double share, double swing = 0.5, bool hasSign = true) {
  gap::Run run =
      pendulumRun([=](double t) { return swing * one(t); }, [=](double t) { return swing * one(t); });
  const double most = swing * 2 * std::numbers::pi * 0.5;
  for (const double t : run.t) {
    const double speed = std::cos(2 * std::numbers::pi * 0.5 * t),
                 rest = std::sqrt(1 - share * share) * (hasSign ? another(t) : std::abs(speed));
    run.channels["vel.pendulum"].push_back(times * most * (share * speed + rest));
  }
  return saidOf(run);
}

TEST(RunFollowing, aSpeedMayBeAThirdOffAndNoMore) {
  EXPECT_EQ(withSpeed(0.7, 1), "");
  EXPECT_EQ(withSpeed(1.5, 1), "");
  EXPECT_EQ(withSpeed(1.8, 1),
            "r: vel.pendulum is left out: it is 1.8 times the speed of pos.pendulum; check its unit\n");
  EXPECT_EQ(withSpeed(0.5, 1),
            "r: vel.pendulum is left out: it is 0.5001 times the speed of pos.pendulum; check its unit\n");
  EXPECT_TRUE(withSpeed(4, 0.7).starts_with("r: vel.pendulum is left out: it is 2.8"))
      << "alike enough to say";
  EXPECT_EQ(withSpeed(4, 0.5), "") << "too unlike to say";
}

TEST(RunFollowing, aSpeedIsInDegreesWhereItIsSoManyTimesTheSpeed) {
  EXPECT_EQ(withSpeed(1.2 * degree, 1, 0.1),
            "r: vel.pendulum is left out: it is 68.77 times the speed of pos.pendulum; is it in degrees?\n");
  EXPECT_NE(withSpeed(1.25 * degree, 1, 0.1).find("; is it in degrees?"), std::string::npos);
  EXPECT_EQ(withSpeed(1.35 * degree, 1, 0.1),
            "r: vel.pendulum is left out: it is 77.36 times the speed of pos.pendulum; check its unit\n");
}

TEST(RunFollowing, aSpeedThatHasLittleToDoWithThePosition) {
  EXPECT_EQ(withSpeed(1, 0.45), "");
  EXPECT_TRUE(withSpeed(1, 0.35).starts_with(
      "r: vel.pendulum: it has little to do with pos.pendulum (correlation 0.3495)"))
      << withSpeed(1, 0.35);
  EXPECT_EQ(withSpeed(1, 0.45, 0.5, false), "") << "alike enough";
  EXPECT_EQ(withSpeed(1, 0.35, 0.5, false),
            "r: vel.pendulum is left out: it has no sign; add to run.json: unsigned: [\"vel\"]\n");
}

TEST(RunFollowing, theSpeedOfAJointThatHardlyMovesIsHeldAgainstNothing) {
  EXPECT_EQ(withSpeed(3, 1, 0.04), "");
  EXPECT_NE(withSpeed(3, 1, 0.05), "");
}

}  // namespace
}  // namespace plumbline::gap
