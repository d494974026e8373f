#include "gap/diagnosis/GaussNewton.h"

#include <gtest/gtest.h>

#include <stdexcept>

#include "../LegOnItsFoot.h"
#include "../TwoJointArm.h"

namespace plumbline::gap {
namespace {

class GaussNewtonTest : public ::testing::Test {
protected:
  static Explanation withValues(Explanation causes, const std::vector<double>& values) {
    for (std::size_t i = 0; i < causes.size(); ++i) causes[i].value = values[i];
    return causes;
  }
  static Evidence recordingOf(const Explanation& causes) {
    return Evidence({recorded(plantOf(arm, causes), armTrial(arm, 3), 5e-4, 3)});
  }

  static inline const Mechanism arm = twoJointArm();
  const Explanation smooth = {causeOfArm("servo_gain", "elbow", 0.7),
                              causeOfArm("viscous_friction", "elbow", 0.15),
                              causeOfArm("coulomb_friction", "elbow", 0.08)};
};

TEST_F(GaussNewtonTest, threeThatMakeUpForEachOtherAreFoundFromFarOff) {
  const Evidence evidence = recordingOf(smooth);
  const Evaluator evaluator(arm, evidence);
  const double truth = evaluator.of(smooth).fitting;
  const GaussNewtonFit found = gaussNewton(evaluator, withValues(smooth, {0.9, 0.03, 0.2}), {0, 1, 2}, 1);
  EXPECT_NEAR(found.causes[0].value, 0.7, 0.002);
  EXPECT_NEAR(found.causes[1].value, 0.15, 0.002);
  EXPECT_NEAR(found.causes[2].value, 0.08, 0.001);
  EXPECT_LE(found.fitting, truth);
  EXPECT_GT(found.fitting, 0.8 * truth);
  EXPECT_DOUBLE_EQ(found.fitting, evaluator.of(found.causes).fitting);
  EXPECT_TRUE(found.settled);
}

TEST_F(GaussNewtonTest, aNarrowValleyOfALimitAndFriction) {
  const Explanation truth = {causeOfArm("acceleration_limit", "elbow", 20),
                             causeOfArm("coulomb_friction", "elbow", 0.08)};
  const Evidence evidence = recordingOf(truth);
  const Evaluator evaluator(arm, evidence);
  const GaussNewtonFit found = gaussNewton(evaluator, withValues(truth, {28, 0.12}), {0, 1}, 1);
  EXPECT_NEAR(found.causes[0].value, 20, 0.05);
  EXPECT_NEAR(found.causes[1].value, 0.08, 0.004);
}

TEST_F(GaussNewtonTest, thoseThatAreNotAskedForStayAndSoDoBounds) {
  const Evidence evidence = recordingOf(smooth);
  const Evaluator evaluator(arm, evidence);
  Explanation start = withValues(smooth, {0.7, 0.1, 0.08});
  GaussNewtonFit found = gaussNewton(evaluator, start, {1}, 1);
  EXPECT_NEAR(found.causes[1].value, 0.15, 0.002);
  EXPECT_EQ(found.causes[0], start[0]);
  EXPECT_EQ(found.causes[2], start[2]);

  // Far stiffer than a gain may be explained by: what is missing pulls it to its bound and not beyond.
  start = {causeOfArm("servo_gain", "shoulder", 0.8)};
  Mechanism stiff = arm;
  stiff.joints[0].servo.kp *= 100;
  const Evidence beyond({recorded(nominalPlant(stiff), armTrial(arm, 3), 5e-4, 3)});
  start[0].value = 2;
  found = gaussNewton(Evaluator(arm, beyond), start, {0}, 1);
  EXPECT_DOUBLE_EQ(found.causes[0].value, start[0].effect->boundsAt(arm, start[0].place).upper);
}

TEST_F(GaussNewtonTest, theSameOnAnyNumberOfThreadsAndWithAnotherBase) {
  const Evidence evidence = recordingOf(smooth);
  Evaluator evaluator(arm, evidence);
  const Explanation start = withValues(smooth, {0.8, 0.1, 0.1});
  const GaussNewtonFit one = gaussNewton(evaluator, start, {0, 1, 2}, 1);
  EXPECT_EQ(gaussNewton(evaluator, start, {0, 1, 2}, 3).causes, one.causes);
  evaluator.setBase(start);
  const GaussNewtonFit other = gaussNewton(evaluator, start, {0, 1, 2}, 1);
  for (std::size_t i = 0; i < 3; ++i) EXPECT_NEAR(other.causes[i].value / one.causes[i].value, 1, 1e-6);
}

TEST_F(GaussNewtonTest, runsOnTheFeetAreRefused) {
  const Mechanism leg = legOnItsFoot();
  const Evidence evidence({recorded(nominalPlant(leg), legTrial(true, 1), 5e-4, 3)});
  const Evaluator evaluator(leg, evidence);
  EXPECT_THROW(gaussNewton(evaluator, {}, {}, 1), std::logic_error);
}

}  // namespace
}  // namespace plumbline::gap
