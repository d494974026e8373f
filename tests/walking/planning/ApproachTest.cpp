#include "walking/planning/Approach.h"

#include <gtest/gtest.h>

#include <cmath>

#include "walking/planning/KickStep.h"
#include "walking/planning/ReferenceTrajectory.h"

namespace plumbline::walking {
namespace {

class ApproachTest : public testing::TestWithParam<Pose2> {};

TEST_P(ApproachTest, theStepsLeadToTheTargetWithinTheLimits) {
  const Pose2 target = GetParam();
  const WalkParameters limits;
  const ApproachPlan plan = planApproach(target, Vec2::Zero(), 0, limits);
  ASSERT_TRUE(plan.complete) << plan.steps.size();
  Pose2 at;
  Vec2 last = Vec2::Zero();
  for (const Pose2& step : plan.steps) {
    const Vec2 speed = step.position / limits.step.duration;
    EXPECT_LE(speed.x(), limits.speed.maxForward + 1e-9);
    EXPECT_GE(speed.x(), -limits.speed.maxBackward - 1e-9);
    EXPECT_LE(std::abs(speed.y()), limits.speed.maxSideways + 0.02);
    EXPECT_LE(std::abs(step.heading), limits.speed.maxTurn * limits.step.duration + 1e-9);
    EXPECT_LE(std::abs(speed.x() - last.x()), limits.speed.accelerationForward * limits.step.duration + 0.06);
    last = speed;
    at = at * step;
  }
  EXPECT_NEAR((at.position - target.position).norm(), 0, 0.01);
  EXPECT_NEAR(at.heading, target.heading, 0.05);
  // The last step is slow enough to be the last.
  EXPECT_LT(last.norm(), 0.15);
}

INSTANTIATE_TEST_SUITE_P(Targets, ApproachTest,
                         testing::Values(Pose2(1, 0), Pose2(-0.3, 0), Pose2(0, 0.4), Pose2(0.05, -0.02, 0.1),
                                         Pose2(0.5, 0.3, 1.2), Pose2(0, 0, -2), Pose2(3, 0.5, 0.3)));

TEST(Approach, aMetreTakesAsLongAsTheAccelerationsAllow) {
  WalkParameters limits;
  const ApproachPlan plan = planApproach(Pose2(1, 0), Vec2::Zero(), 0, limits);
  // At 0.5 m/s^2 up to 0.5 m/s and down at 0.35: 1 s, 0.25 m; 1.43 s, 0.36 m; the rest at full speed.
  const double ideal = 1 + 1.43 + (1 - 0.25 - 0.36) / 0.5;
  const double time = static_cast<double>(plan.steps.size()) * limits.step.duration;
  EXPECT_GT(time, ideal - 0.4);
  EXPECT_LT(time, ideal + 1.2);
}

TEST(Approach, atTheTargetThereIsNothingToDo) {
  const ApproachPlan plan = planApproach(Pose2(0.005, 0, 0.01), Vec2::Zero(), 0, WalkParameters{});
  EXPECT_TRUE(plan.complete);
  EXPECT_TRUE(plan.steps.empty());
  EXPECT_EQ(plan.velocity, Vec2(0, 0));
}

TEST(KickStep, theFootIsDrawnBackThrownForwardAndBackOnItsWay) {
  const KickStep kick{.back = 0.04, .forward = 0.09, .drawn = 0.35, .thrown = 0.62};
  EXPECT_DOUBLE_EQ(kick.offset(0), 0);
  EXPECT_NEAR(kick.offset(0.35), -0.04, 1e-12);
  EXPECT_NEAR(kick.offset(0.62), 0.09, 1e-12);
  EXPECT_DOUBLE_EQ(kick.offset(1), 0);
  double fastest = 0;
  for (double phase = 0; phase < 1; phase += 0.001)
    fastest = std::max(fastest, (kick.offset(phase + 0.001) - kick.offset(phase)) / 0.001);
  EXPECT_NEAR(fastest, 0.13 * pi / 2 / 0.27, 1e-2);
}

}  // namespace
}  // namespace plumbline::walking
