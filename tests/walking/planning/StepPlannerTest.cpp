#include "walking/planning/StepPlanner.h"

#include <gtest/gtest.h>

#include <cmath>

#include "walking/model/LinearInvertedPendulum.h"

namespace plumbline::walking {
namespace {

class StepPlannerTest : public testing::Test {
protected:
  static ReferenceTrajectory walking(const Vec2& velocity, double turn = 0) {
    return findReferenceTrajectory(model(), {.velocity = velocity, .turn = turn, .stepDuration = 0.2});
  }
  static const LinearInvertedPendulum& model() {
    static const LinearInvertedPendulum pendulum(0.25);
    return pendulum;
  }
  static WalkState standing() {
    WalkState state;
    state.foot = {Pose2(0, 0.055), Pose2(0, -0.055)};
    return state;
  }
  StepLimits limits;
  StepPlanner planner{model(), limits};
};

TEST_F(StepPlannerTest, onTheReferenceItPlansTheReference) {
  const ReferenceTrajectory reference = walking(Vec2(0.4, 0.1), 0.5);
  for (const std::size_t foot : {0u, 1u}) {
    const WalkAction action = planner.step(reference.begin[foot], 0, reference);
    EXPECT_NEAR(action.duration, 0.2, 0.002);
    EXPECT_NEAR(action.turn, 0.1, 1e-3);
    EXPECT_NEAR((action.stepTarget.position - reference.action[foot].stepTarget.position).norm(), 0, 2e-3);
    EXPECT_NEAR(action.stepTarget.heading, reference.action[foot].stepTarget.heading, 1e-9);
  }
}

TEST_F(StepPlannerTest, canHoldWhatTheSolesReach) {
  const double rate = std::sqrt(9.81 / 0.25);
  WalkState state = standing();
  EXPECT_TRUE(planner.canHold(state, 0));
  // The capture point is as far ahead as the velocity over the pendulum's rate: 5 cm are on the soles.
  state.velocity.x() = 0.048 * rate;
  EXPECT_TRUE(planner.canHold(state, 0));
  state.velocity.x() = 0.06 * rate;
  EXPECT_FALSE(planner.canHold(state, 0));
  EXPECT_TRUE(planner.canHold(state, 0.02));
  // Sideways both feet hold.
  state.velocity = Vec2(0, -0.07 * rate);
  EXPECT_TRUE(planner.canHold(state, 0));
  state.velocity = Vec2(0, -0.08 * rate);
  EXPECT_FALSE(planner.canHold(state, 0));
}

TEST_F(StepPlannerTest, planningAgainInTheMiddleOfAStepChangesNothing) {
  const ReferenceTrajectory reference = walking(Vec2(0.4, 0));
  const WalkAction whole = planner.step(reference.begin[1], 0, reference);
  const WalkState middle = model().move(reference.begin[1], whole, 0.08);
  const WalkAction rest = planner.step(middle, 0.08, reference);
  EXPECT_NEAR(rest.duration, whole.duration - 0.08, 1e-3);
  EXPECT_NEAR((rest.stepTarget.position - whole.stepTarget.position).norm(), 0, 1e-3);
}

TEST_F(StepPlannerTest, aDisturbedWalkIsBackOnTheReferenceAfterTwoSteps) {
  const ReferenceTrajectory reference = walking(Vec2(0.2, 0));
  WalkState state = reference.begin[0];
  state.velocity += Vec2(0.05, 0.03);
  state = model().predict(state, planner.step(state, 0, reference));
  state = model().predict(state, planner.step(state, 0, reference));
  EXPECT_NEAR((state.velocity - reference.begin[0].velocity).norm(), 0, 0.005);
  state = model().predict(state, planner.step(state, 0, reference));
  EXPECT_NEAR((state.velocity - reference.begin[1].velocity).norm(), 0, 0.005);
}

TEST_F(StepPlannerTest, pushedToTheSideItStepsWiderAndPushedInwardItWaits) {
  const ReferenceTrajectory reference = walking(Vec2::Zero());
  WalkState state = reference.begin[0];  // on the left foot, mass moves to the left
  const WalkAction calm = planner.step(state, 0, reference);
  state.velocity.y() = reference.begin[0].velocity.y() - 0.08;  // towards the swing foot
  const WalkAction pushed = planner.step(state, 0, reference);
  EXPECT_LT(pushed.duration, calm.duration - 0.02) << "the next foot is needed earlier";
  state.velocity.y() = reference.begin[0].velocity.y() + 0.04;
  EXPECT_GT(planner.step(state, 0, reference).duration, calm.duration + 0.02) << "the mass comes back later";
  state.velocity.y() = reference.begin[0].velocity.y() + 0.3;
  EXPECT_NEAR(planner.step(state, 0, reference).duration, limits.maxDuration, 1e-9)
      << "it does not come back";
}

TEST_F(StepPlannerTest, limitsOfTheTargetAreKept) {
  const Pose2 support(0, 0.05);
  const auto limited = [&](const Pose2& target) { return planner.limitTarget(target, support, Side::right); };
  EXPECT_DOUBLE_EQ(limited(Pose2(0.5, -0.06)).x(), limits.forward);
  EXPECT_DOUBLE_EQ(limited(Pose2(-0.5, -0.06)).x(), -limits.backward);
  EXPECT_DOUBLE_EQ(limited(Pose2(0, -0.5)).y(), -limits.maxOutward);
  EXPECT_NEAR(limited(Pose2(0, 0.03)).y(), 0.05 - 2 * limits.minOutward, 1e-12) << "feet must not cross";
  EXPECT_DOUBLE_EQ(limited(Pose2(0, -0.06, -0.3)).heading, -0.3) << "toes outward";
  EXPECT_DOUBLE_EQ(limited(Pose2(0, -0.06, 0.3)).heading, 0.015) << "toes inward";
  const Pose2 inside(0.03, -0.06, -0.1);
  EXPECT_EQ(limited(inside).position, inside.position);
}

TEST_F(StepPlannerTest, theLegIsLongEnoughForEveryTarget) {
  limits.reach = 0.07;
  limits.forward = 0.2;
  const StepPlanner shortLegged(model(), limits);
  const Pose2 target = shortLegged.limitTarget(Pose2(0.15, -0.12), Pose2(0, 0.05), Side::right);
  EXPECT_NEAR((target.position - Vec2(0, -limits.hipY)).norm(), 0.07, 1e-12);
}

TEST_F(StepPlannerTest, aSuddenRequestIsReachedInFeasibleSteps) {
  WalkState state = walking(Vec2::Zero()).begin[0];
  const ReferenceTrajectory fast = walking(Vec2(0.5, 0));
  int steps = 0;
  for (; steps < 20; ++steps) {
    const std::size_t foot = index(state.supportSide());
    if ((state.velocity - fast.begin[foot].velocity).norm() < 0.01) break;
    const WalkAction action = planner.step(state, 0, fast);
    EXPECT_LE(action.stepTarget.x(), limits.forward);
    EXPECT_GE(action.stepTarget.x(), -limits.backward);
    state = model().predict(state, action);
  }
  EXPECT_GE(steps, 2);
  EXPECT_LE(steps, 8);
}

TEST_F(StepPlannerTest, startShiftsTheWeightForTheFirstStep) {
  const ReferenceTrajectory reference = walking(Vec2(0.1, 0));
  const WalkAction shift = planner.start(standing(), 0.15, Side::right, reference);
  EXPECT_GT(shift.centerOfPressure.y(), 0) << "pressed on the left to fall to the right";
  EXPECT_LE(shift.centerOfPressure.y(), 0.055 + limits.pressure.y() + 1e-12);
  EXPECT_LT(shift.centerOfPressure.x(), 0) << "pressed behind to fall forward";
  WalkState state = model().predict(standing(), shift);
  state.support = Support::right;
  state = model().predict(state, reference.action[1]);
  EXPECT_NEAR((state.velocity - reference.begin[0].velocity).norm(), 0, 2e-3) << "no stepping on the spot";
}

TEST_F(StepPlannerTest, pressureStaysOnTheSoles) {
  const ReferenceTrajectory reference = walking(Vec2(1, 0));
  const WalkAction shift = planner.start(standing(), 0.05, Side::left, reference);
  EXPECT_NEAR(shift.centerOfPressure.x(), -limits.pressure.x(), 1e-12);
  EXPECT_NEAR(shift.centerOfPressure.y(), -0.055 - limits.pressure.y(), 1e-12);
}

TEST_F(StepPlannerTest, standBringsTheMassToRestInTheMiddle) {
  WalkState state = standing();
  state.velocity = Vec2(0.05, 0.15);
  ASSERT_TRUE(planner.canStand(state));
  for (int i = 0; i < 75; ++i) state = model().predict(state, planner.stand(state, 0.02));
  EXPECT_LT(state.velocity.norm(), 0.01);
  EXPECT_LT((state.foot[0].position + state.foot[1].position).norm() / 2, 0.003);
  state.velocity.x() = 0.6;
  EXPECT_FALSE(planner.canStand(state));
}

TEST_F(StepPlannerTest, standsSoonerWhenTheMassMovesFasterToTheMiddle) {
  const auto secondsToTheMiddle = [this] {
    WalkState state = standing();
    state.velocity = Vec2(0, 0.15);
    int cycles = 0;
    for (; cycles < 100; ++cycles) {
      const Vec2 middle = (state.foot[0].position + state.foot[1].position) / 2;
      if (cycles > 0 && state.velocity.norm() < 0.02 && middle.norm() < 0.005) break;
      state = model().predict(state, planner.stand(state, 0.02));
    }
    return 0.02 * cycles;
  };
  const double slow = secondsToTheMiddle();
  limits.calmRate = 20;
  limits.calmTime = 0.1;
  planner.setLimits(limits);
  EXPECT_LT(secondsToTheMiddle(), 0.7 * slow);
}

}  // namespace
}  // namespace plumbline::walking
