#include "walking/planning/Sprint.h"

#include <gtest/gtest.h>

#include <array>

namespace plumbline::walking {
namespace {

using enum SprintState;

TEST(SprintState, everyTransition) {
  struct Row {
    SprintState from;
    SprintConditions conditions;
    SprintState to;
  };
  const Row rows[] = {
      {none, {}, none},
      {none, {.ready = true}, none},
      {none, {.asked = true}, preparing},
      {none, {.asked = true, .ready = true}, running},
      {preparing, {}, none},
      {preparing, {.asked = true}, preparing},
      {preparing, {.asked = true, .ready = true}, running},
      {running, {.asked = true, .slow = true, .settled = true}, running},
      {running, {}, braking},
      {braking, {.asked = true}, braking},
      {braking, {.slow = true}, settling},
      {settling, {.asked = true, .slow = true}, settling},
      {settling, {.settled = true}, settling},
      {settling, {.slow = true, .settled = true}, none},
  };
  for (const Row& row : rows)
    EXPECT_EQ(nextSprintState(row.from, row.conditions), row.to) << "row " << &row - rows;
}

class SprintTest : public testing::Test {
protected:
  SprintTest() {
    p.speed.maxForward = 1;
    p.speed.omniForward = 0.6;
    p.sprint.patience = 0.04;
    p.sprint.settleTime = 0.04;
    p.sprint.riseTime = 2;
    p.sprint.fallTime = 0.5;
  }
  double target(double wish, double now) {
    return sprint.target(Vec3(wish, 0, 0), Vec3(now, 0, 0), p, 0.02).x();
  }
  WalkParameters p;
  Sprint sprint;
};

TEST_F(SprintTest, goesThroughItsStatesInTheirOrder) {
  EXPECT_DOUBLE_EQ(target(1, 0.3), 0.6);
  EXPECT_EQ(sprint.state(), none) << "it may not be meant";
  for (int i = 0; i < 2; ++i) target(1, 0.3);
  EXPECT_EQ(sprint.state(), preparing);
  EXPECT_FALSE(sprint.active());
  EXPECT_EQ(target(1, 0.6), 1);
  EXPECT_EQ(sprint.state(), running);
  EXPECT_EQ(sprint.axis(), 0);
  EXPECT_NEAR(sprint.acceleration(5, Vec3(0.7, 0, 0), p), 0.4 / 2, 1e-12);
  EXPECT_EQ(target(0.3, 0.8), 0.3);
  EXPECT_EQ(sprint.state(), braking);
  EXPECT_NEAR(sprint.acceleration(5, Vec3(0.7, 0, 0), p), 0.4 / 0.5, 1e-12);
  EXPECT_EQ(target(1, 0.7), 0.6) << "it does not begin anew";
  EXPECT_EQ(sprint.state(), braking);
  target(0.3, 0.6);
  EXPECT_EQ(sprint.state(), settling);
  target(0.3, 0.5);
  EXPECT_EQ(sprint.state(), settling);
  target(0.3, 0.4);
  EXPECT_EQ(sprint.state(), none);
  EXPECT_EQ(sprint.axis(), -1);
}

TEST_F(SprintTest, settlesInTheSameCycleWhereNoTimeIsAskedFor) {
  p.sprint.settleTime = 0;
  for (int i = 0; i < 4; ++i) target(1, 0.6);
  ASSERT_EQ(sprint.state(), running);
  EXPECT_EQ(target(0.3, 0.6), 0.3);
  EXPECT_EQ(sprint.state(), none);
}

}  // namespace
}  // namespace plumbline::walking
