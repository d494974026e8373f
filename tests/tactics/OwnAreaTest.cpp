#include "tactics/OwnArea.h"

#include <gtest/gtest.h>

using namespace plumbline;

namespace {

// The league's begins at -13.2 m and is 6 m wide.
const OwnArea area{FieldSize()};

TEST(OwnAreaTest, measuresHowFarAPlaceIsFromIt) {
  EXPECT_NEAR(area.distance({-12, 1}), 1.2, 1e-9);
  EXPECT_NEAR(area.distance({-14, -3.5}), 0.5, 1e-9);
  EXPECT_NEAR(area.distance({-12.9, 3.4}), 0.5, 1e-9) << "from the corner";
  EXPECT_NEAR(area.distance({-14.2, 2.5}), -0.5, 1e-9);
}

TEST(OwnAreaTest, thePlaceOutsideIsTheNearestOne) {
  EXPECT_LT((area.keptOut({-13.5, 0}, 0.5) - Vec2(-12.7, 0)).norm(), 1e-9);
  EXPECT_LT((area.keptOut({-14.5, -2.5}, 0.5) - Vec2(-14.5, -3.5)).norm(), 1e-9);
  EXPECT_EQ(area.keptOut({-12, 0}, 0.5), Vec2(-12, 0));
  EXPECT_GT(area.keptOut({-15.5, 2.9}, 0.5).x(), -15) << "on the field";
}

TEST(OwnAreaTest, stopsAWalkBeforeIt) {
  for (const Vec2& from : {Vec2(-11, 0), Vec2(-14, 5), Vec2(-12, 4)}) {
    Vec2 place = from;
    for (int cycle = 0; cycle < 1000; ++cycle)
      place += 0.02 * area.stoppedBefore(Vec2(-14, 0) - place, place, 0.6);
    EXPECT_NEAR(area.distance(place), OwnArea::leaveDistance, 0.02);
  }
  EXPECT_EQ(area.stoppedBefore({1, 0}, {-13, 0}, 0.6), Vec2(1, 0)) << "away from it";
  EXPECT_EQ(area.stoppedBefore({0, 1}, {-13, 0}, 0.6), Vec2(0, 1)) << "along it";
  EXPECT_EQ(area.stoppedBefore({-1, 0}, {-14, 0}, 0.6), Vec2(-1, 0)) << "within it";
}

}  // namespace
