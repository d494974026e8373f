#include "gap/inference/Interval.h"

#include <gtest/gtest.h>

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

TEST(Interval, goesAsFarAsNothingChanges) {
  // A servo's duty tells which command was in force when it was read, once a cycle of 10 ms: all delays
  // within the cycle are alike. The angle, which would tell more, is hardly known.
  const Mechanism pendulum = findMechanism("xl330_pendulum");
  const Cause delay = causeOf(pendulum, "command_delay", "pendulum", 0.024);
  std::vector<Trial> trials{dutyTrial({delay}, 4, 0, 3), dutyTrial({delay}, 4, 0, 4, 0.3)};
  for (Trial& trial : trials)
    std::erase_if(trial.signals, [](const Signal& signal) {
      return signal.kind != SignalKind::duty && signal.kind != SignalKind::position;
    });
  const Groups groups(trials);
  const Replayer replayer(pendulum, groups, 1);
  const Scored scored = score(replayer, sharesOf(groups, replayer.residuals({delay})), {delay}, 20, 12);
  const Bounds interval = intervalsOf(replayer, scored).front();
  EXPECT_LE(interval.lower, 0.0225);
  EXPECT_GE(interval.upper, 0.0275);
  EXPECT_GT(interval.lower, 0.018);
  EXPECT_LT(interval.upper, 0.032);
}

TEST(Interval, thereIsNoneWithoutCauses) {
  const Mechanism arm = twoJointArm();
  const Groups groups(recordings({}));
  EXPECT_TRUE(intervalsOf(Replayer(arm, groups, 1), Scored{}).empty());
}

}  // namespace plumbline::gap
