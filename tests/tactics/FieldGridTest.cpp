#include "tactics/FieldGrid.h"

#include <gtest/gtest.h>

using namespace plumbline;

namespace {

const FieldGrid grid({-10, 0, 10}, {0, 4});

TEST(FieldGridTest, hasAPointForEachPlaceAndAdvantage) {
  ASSERT_EQ(grid.size(), 18u);
  const BallState state = grid.state(grid.point(2, 1, 0));
  EXPECT_EQ(state.place, Vec2(10, 4));
  EXPECT_EQ(state.advantage, -1);
}

TEST(FieldGridTest, weightsGiveBackTheState) {
  const BallState state{{-2.5, -3}, 0.25};
  double sum = 0, x = 0, y = 0, advantage = 0;
  for (const FieldGrid::Weight& weight : grid.weights(state)) {
    const BallState point = grid.state(weight.point);
    sum += weight.weight;
    x += weight.weight * point.place.x();
    y += weight.weight * point.place.y();
    advantage += weight.weight * point.advantage;
  }
  EXPECT_NEAR(sum, 1, 1e-12);
  EXPECT_NEAR(x, -2.5, 1e-12);
  EXPECT_NEAR(y, 3, 1e-12);  // both sides are one
  EXPECT_NEAR(advantage, 0.25, 1e-12);
}

TEST(FieldGridTest, beyondTheBorderCountsAsAtIt) {
  for (const FieldGrid::Weight& weight : grid.weights({{50, 50}, 5}))
    EXPECT_EQ(weight.weight, weight.point == grid.point(2, 1, 2) ? 1 : 0);
}

TEST(FieldGridTest, twoSecondsAreAWholeAdvantage) {
  EXPECT_DOUBLE_EQ(ballAdvantage(3, 4), 0.5);
  EXPECT_DOUBLE_EQ(ballAdvantage(4, 3), -0.5);
  EXPECT_DOUBLE_EQ(ballAdvantage(1, 9), 1);
}

}  // namespace
