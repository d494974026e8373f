#include "modules/motion/WalkDrawing.h"

#include <gtest/gtest.h>

#include "simspark/LeagueRobots.h"

namespace plumbline {
namespace {

using shapes::Line;

/// A robot that has walked forward for a while with joints that are where they should be.
struct WalkDrawingTest : testing::Test {
  walking::WalkEngine engine{walking::WalkParameters{}, simsparkRobot(0)};
  Drawing drawing;

  void walk(double forward, double seconds) {
    walking::WalkSensors sensors;
    sensors.dt = 0.02;
    for (int i = 0; i < seconds / sensors.dt; ++i)
      sensors.angles = engine.update({Vec2(forward, 0), 0, true}, sensors).angles;
  }
  /// The middle of the sole whose outline is the n-th: where its heading's line begins.
  Vec2 sole(std::size_t n) const {
    return std::get<Line>(drawing.shapes().at(5 * n + 4).form).begin.head<2>();
  }
};

TEST_F(WalkDrawingTest, plannedStepsGoOnInTurnAndForward) {
  walk(0.3, 3);
  drawPlannedSteps(drawing, engine, 5);
  ASSERT_EQ(drawing.shapes().size(), 25u);
  const auto& state = engine.state();
  for (std::size_t i = 0; i < 5; ++i) {
    const bool left = (state.supportSide() == Side::right) == (i % 2 == 0);
    EXPECT_GT((left ? 1 : -1) * sole(i).y(), 0.02) << "left and right in turn, step " << i;
    if (i == 0) continue;
    EXPECT_NEAR(sole(i).x() - sole(i - 1).x(), 0.3 * engine.gait().step.duration, 0.02) << "step " << i;
  }
}

TEST_F(WalkDrawingTest, stepsOnTheSpotAreDrawnNextToEachOther) {
  walk(0, 2);
  drawPlannedSteps(drawing, engine, 2);
  ASSERT_EQ(drawing.shapes().size(), 10u);
  EXPECT_NEAR(sole(0).x(), sole(1).x(), 0.01);
}

TEST_F(WalkDrawingTest, aStandHasFeetAndNoSteps) {
  drawPlannedSteps(drawing, engine, 3);
  EXPECT_TRUE(drawing.shapes().empty());
  drawWalk(drawing, engine);
  EXPECT_GT(drawing.shapes().size(), 20u);
}

}  // namespace
}  // namespace plumbline
