#include "gap/diagnosis/Probability.h"

#include <gtest/gtest.h>

#include <cmath>

namespace plumbline::gap {
namespace {

FittedCause candidate(const char* id, double judging, double value = 1) {
  FittedCause c;
  c.cause = {findEffect(id), {}, value, 0};
  c.fit.judging = judging;
  return c;
}

TEST(ProbabilityTest, aSideOfNominalHasHalfOfThePrior) {
  // Friction can only be more than none; damping may be more or less.
  std::vector<FittedCause> list = {candidate("servo_damping", 0), candidate("viscous_friction", 0)};
  sortByProbability(list);
  EXPECT_EQ(list[0].cause.effect->id, "viscous_friction");
  const std::vector<double> p = probabilities(list);
  EXPECT_NEAR(p[0], 2.0 / 3, 1e-12);
  EXPECT_NEAR(p[1], 1.0 / 3, 1e-12);
}

TEST(ProbabilityTest, anAxisHasAThirdOfThePrior) {
  std::vector<FittedCause> list = {candidate("bias_force", 0), candidate("com_offset", 0)};
  const std::vector<double> p = probabilities(list);
  EXPECT_NEAR(p[0] / p[1], 3, 1e-9);  // both have two sides
}

TEST(ProbabilityTest, massIsRatherAddedThanTakenOff) {
  std::vector<FittedCause> list = {candidate("link_mass", 0, 0.1), candidate("link_mass", 0, -0.1)};
  const std::vector<double> p = probabilities(list);
  EXPECT_NEAR(p[0] / p[1], 4, 1e-9);
}

TEST(ProbabilityTest, whatPredictsBetterWinsByTheTemperature) {
  // 16 per nat, and 0.0014 of the sum of squares for what engines differ by.
  std::vector<FittedCause> list = {candidate("viscous_friction", 10000),
                                   candidate("coulomb_friction", 10060)};
  const std::vector<double> p = probabilities(list);
  EXPECT_NEAR(std::log(p[0] / p[1]), 60 / (16 + 0.0014 * 10000), 1e-9);
  EXPECT_TRUE(probabilities({}).empty());
}

TEST(ProbabilityTest, whatNoCauseExplainsMayBeWhatOneExplainsBetter) {
  std::vector<FittedCause> list = {candidate("viscous_friction", 10000),
                                   candidate("coulomb_friction", 10060)};
  const std::vector<double> p = probabilities(list, 300);
  EXPECT_NEAR(std::log(p[0] / p[1]), 60 / (16 + 0.0014 * 10000 + 2 * 300), 1e-9);
  // A force in any direction against an offset: 200 squares count for less than the prior of three.
  list = {candidate("external_force", 10000), candidate("joint_offset", 10200)};
  sortByProbability(list);
  EXPECT_EQ(list[0].cause.effect->id, "external_force");
  sortByProbability(list, 300);
  EXPECT_EQ(list[0].cause.effect->id, "joint_offset");
}

TEST(ProbabilityTest, aPriorInSquares) {
  // A force in one of three directions and either way has a sixth, dry friction has all of it.
  const FittedCause force = candidate("external_force", 10000),
                    friction = candidate("coulomb_friction", 10000);
  EXPECT_DOUBLE_EQ(withPrior(friction.cause, 10000), 10000);
  EXPECT_NEAR(withPrior(force.cause, 10000), 10000 + (16 + 0.0014 * 10000) * std::log(6), 1e-9);
}

}  // namespace
}  // namespace plumbline::gap
