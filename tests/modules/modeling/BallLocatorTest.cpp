#include "modules/modeling/BallLocator.h"

#include <gtest/gtest.h>

#include "support/DrawnBy.h"
#include "support/ModuleHarness.h"

namespace plumbline {
namespace {

/// A robot that stands and looks ahead; an image in each cycle.
struct Watcher {
  test::ModuleHarness<BallLocator> harness;
  FrameInfo& frame = harness.input<FrameInfo>();
  BallPercept& percept = harness.input<BallPercept>();

  Watcher() {
    harness.input<VisionInfo>().newImage = true;
    harness.input<TorsoPose>().valid = true;
  }
  const LocalBallPos& see(const Vec2& position) {
    percept.seen = true;
    percept.position = position;
    return next();
  }
  const LocalBallPos& miss(int images) {
    percept.seen = false;
    for (int i = 1; i < images; ++i) next();
    return next();
  }
  const LocalBallPos& next() {
    frame.time += 0.06;
    frame.cycleSeconds = 0.06;
    harness.cycle();
    return harness.output<LocalBallPos>();
  }
};

TEST(BallLocator, aBallThatIsNotWhereItShouldBeSeenIsLost) {
  Watcher robot;
  EXPECT_TRUE(robot.see(Vec2(3, 0)).valid);
  EXPECT_TRUE(robot.miss(3).valid);
  EXPECT_FALSE(robot.miss(1).valid);
}

/// One percept far off from where the ball was thought to be waits for a second one. While the ball counts as
/// lost it was believed back in the old place instead, and the robot turned there, away from the ball.
TEST(BallLocator, aLostBallIsWhereItIsSeenNext) {
  Watcher robot;
  for (int i = 0; i < 5; ++i) robot.see(Vec2(3, 0));
  EXPECT_FALSE(robot.miss(10).valid);
  const LocalBallPos& found = robot.see(Vec2(-1, 2));
  EXPECT_TRUE(found.valid);
  EXPECT_NEAR(found.position.x(), -1, 1e-9);
  EXPECT_NEAR(found.position.y(), 2, 1e-9);
  EXPECT_TRUE(found.velocity.isZero());
}

TEST(BallLocator, aSinglePerceptFarOffDoesNotMoveABallThatIsKnown) {
  Watcher robot;
  for (int i = 0; i < 5; ++i) robot.see(Vec2(3, 0));
  EXPECT_NEAR(robot.see(Vec2(-1, 2)).position.x(), 3, 0.05);
}

TEST(BallLocator, theBallIsDrawnWithAnEllipseAlongTheLineOfSight) {
  Watcher robot;
  robot.see(Vec2(5, 0));
  const Drawing drawing = test::drawnBy("draw:BallLocator:ball", [&] { robot.see(Vec2(5, 0)); });
  double along = 0, across = 0;
  for (const shapes::Shape& shape : drawing.shapes())
    if (const auto* line = std::get_if<shapes::Line>(&shape.form); line && line->thickness == 1) {
      along = std::max(along, std::abs(line->begin.x() - 5));
      across = std::max(across, std::abs(line->begin.y()));
    }
  EXPECT_GT(along, 0);
  EXPECT_NE(along, across);
  EXPECT_NEAR(std::sqrt(along * along + across * across),
              2 * std::sqrt(2.0) * robot.harness.output<LocalBallPos>().deviation, 1e-6)
      << "two standard deviations";
}

}  // namespace
}  // namespace plumbline
