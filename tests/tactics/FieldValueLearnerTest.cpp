#include "tactics/FieldValueLearner.h"

#include <gtest/gtest.h>

using namespace plumbline;

namespace {

FieldValueLearner::Options withPrior(double steps) {
  FieldValueLearner::Options options;
  options.priorSteps = steps;
  return options;
}

// A ball that goes a point forward or back with the same chance, and into the goal from the last: the value
// is linear in the place (the gambler's ruin).
TEST(FieldValueLearnerTest, findsTheGamblersRuin) {
  FieldValueLearner learner(FieldGrid({-9, -3, 3, 9}, {0, 1}), withPrior(1e-9));
  for (const double advantage : {-1.0, 0.0, 1.0})
    for (const double y : {0.0, 1.0}) {
      for (double x = -9; x < 9; x += 6) {
        learner.addStep({{x, y}, advantage}, {{x + 6, y}, advantage});
        learner.addStep({{x + 6, y}, advantage}, {{x, y}, advantage});
      }
      learner.addGoal({{9, y}, advantage}, true);
      learner.addGoal({{-9, y}, advantage}, false);
    }
  EXPECT_EQ(learner.steps(), 48u);
  EXPECT_EQ(learner.goals(), 12u);
  const FieldValue value = learner.learn();
  for (const double x : {-9.0, -3.0, 3.0, 9.0}) EXPECT_NEAR(value.at({{x, 0}, 1}), x / 15, 1e-6) << x;
}

TEST(FieldValueLearnerTest, whatIsGoodForUsIsBadForThem) {
  FieldValueLearner learner(FieldGrid({-10, 0, 10}, {0, 5}), withPrior(2));
  learner.addStep({{0, 5}, 1}, {{10, 0}, 1});
  learner.addStep({{0, 5}, 1}, {{10, 5}, 0});
  learner.addGoal({{10, 0}, 1}, true);
  const FieldValue value = learner.learn();
  for (double x = -10; x <= 10; x += 5)
    for (const double advantage : {-1.0, -0.3, 0.0, 1.0})
      EXPECT_NEAR(value.at({{x, 2}, advantage}), -value.at({{-x, 2}, -advantage}), 1e-6);
  EXPECT_GT(value.at({{0, 5}, 1}), 0.1);
}

TEST(FieldValueLearnerTest, withoutGamesABallIsWorthMoreBeforeTheGoal) {
  const FieldValue value = FieldValueLearner(FieldGrid({-14, -7, 0, 7, 14}, {0, 5, 9}), withPrior(1)).learn();
  EXPECT_NEAR(value.at({{0, 0}, 0}), 0, 1e-6);
  EXPECT_GT(value.at({{14, 0}, 0}), value.at({{7, 0}, 0}));
  EXPECT_GT(value.at({{14, 0}, 0}), value.at({{14, 9}, 0}));
}

}  // namespace
