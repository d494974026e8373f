#include "trials/KickMeasure.h"

#include <gtest/gtest.h>

#include <cmath>
#include <map>

#include "math/Angle.h"

namespace plumbline {
namespace {

/// A ball that flies from (1, 2) to 5 m ahead of it and 1 m to the left, in a parabola 1 m high; the robot
/// looks along y.
TaskOutcome judged(const KickOptions& options, double height = 1) {
  const Pose2 robot(1, 1.8, pi / 2);
  KickMeasure measure(options, robot, Vec2(1, 2));
  const auto onField = [&](double along, double left) { return Vec2(1 - left, 2 + along); };
  for (double share = 0; share <= 1; share += 0.01) {
    const Vec2 ball = onField(5 * share, share);
    measure.see(Vec3(ball.x(), ball.y(), 0.042 + height * 4 * share * (1 - share)));
  }
  return measure.outcome({onField(5, 1), 400, 2.5, true});
}

std::map<std::string, double> figuresOf(const TaskOutcome& outcome) {
  return {outcome.figures.begin(), outcome.figures.end()};
}

TEST(KickMeasure, theCostIsTheThesisFormula) {
  const TaskOutcome outcome = judged({});
  EXPECT_NEAR(outcome.cost, -30 * (5 - 1) - 120 + 2.5 + 0.08 * 400, 1e-9);
  auto figures = figuresOf(outcome);
  EXPECT_NEAR(figures["distance"], 5, 1e-12);
  EXPECT_NEAR(figures["direction"], toDegrees(std::atan2(1, 5)), 1e-9);
  EXPECT_NEAR(figures["off"], figures["direction"], 1e-9);
  EXPECT_NEAR(figures["height"], 1, 1e-9);
  EXPECT_EQ(figures["time"], 400);
  EXPECT_EQ(figures["error"], 2.5);
  EXPECT_EQ(figures["up"], 1);
}

TEST(KickMeasure, aKickIsJudgedInTheWantedDirection) {
  KickOptions options;
  options.direction = 30;
  const TaskOutcome outcome = judged(options);
  const double length = std::sqrt(26.0), off = std::atan2(1, 5) - pi / 6;
  auto figures = figuresOf(outcome);
  EXPECT_NEAR(figures["distance"], length * std::cos(off), 1e-9);
  EXPECT_NEAR(figures["direction"], toDegrees(std::atan2(1, 5)), 1e-9) << "of forward";
  EXPECT_NEAR(figures["off"], toDegrees(-off), 1e-9);
  EXPECT_NEAR(outcome.cost, -30 * length * (std::cos(off) - std::abs(std::sin(off))) - 120 + 2.5 + 32, 1e-9);
}

TEST(KickMeasure, aShotThatFliesOverTheCeilingCosts) {
  KickOptions options;
  options.wish.ceiling = 0.8;
  auto high = figuresOf(judged(options)), low = figuresOf(judged(options, 0.1));
  EXPECT_NEAR(high["top"], 0.084 + 1 * 4 * 0.59 * 0.41, 0.01) << "highest from 3 m on";
  EXPECT_EQ(high["low"], 0);
  EXPECT_EQ(low["low"], 1);
  EXPECT_NEAR(judged(options).cost - judged(options, 0.1).cost, 60 + 300 * (high["top"] - 0.8), 1e-9);
}

}  // namespace
}  // namespace plumbline
