#include "modules/modeling/OppAnalyzer.h"

#include <gtest/gtest.h>

#include "support/ModuleHarness.h"
#include "support/Robots.h"

using namespace plumbline;

namespace {

/// Opponents and ball as the world says them, 50 times a second.
struct OppAnalyzerTest : testing::Test {
  OppAnalyzerTest() {
    harness.input<FrameInfo>().cycleSeconds = 0.02;
    harness.input<BallPos>().valid = true;
    harness.input<BallPos>().age = 0;
    harness.input<BallPos>().relative = {5, 0};
    harness.input<OtherRobots>();
  }
  OtherRobot& add(bool mate, int number, const Vec2& place) {
    return test::addRobot(harness.input<OtherRobots>().robots, mate, place, number);
  }
  const OppInfo& after(double seconds) {
    for (double t = 0; t < seconds; t += 0.02) {
      harness.input<FrameInfo>().time += 0.02;
      for (OtherRobot& robot : harness.input<OtherRobots>().robots)
        robot.lastSeen = harness.input<FrameInfo>().time;
      harness.cycle();
    }
    return harness.output<OppInfo>();
  }
  test::ModuleHarness<OppAnalyzer> harness;
};

TEST_F(OppAnalyzerTest, learnsHowFastTheyWalkFromThoseThatDo) {
  add(false, 2, {3, 0}).velocity = {0.5, 0};
  add(false, 3, {6, 2}).velocity = {0.05, 0};  // stands
  add(true, 4, {1, 1}).velocity = {1.5, 0};    // a mate
  EXPECT_NEAR(after(20).walkSpeed, 0.65, 0.01) << "as long seen as expected";
  EXPECT_NEAR(after(380).walkSpeed, 0.5, 0.02);
}

TEST_F(OppAnalyzerTest, saysWhoIsFirstAtTheBall) {
  EXPECT_GT(after(0.02).timeToBall, 100) << "nobody is known";
  add(false, 2, {0.4 + 0.8, 0}).fallen = true;
  add(false, 3, {0, 0.4 + 2.4});
  add(true, 4, {0.5, 0});
  EXPECT_NEAR(after(0.02).timeToBall, 3, 1e-6);
  EXPECT_EQ(after(0.02).nearest, 3);
}

TEST_F(OppAnalyzerTest, remembersTheirFarthestKick) {
  add(false, 2, {0.2, 0});
  EXPECT_EQ(after(0.1).kickDistance, 0);
  harness.input<BallPos>().relativeVelocity = {0, 6};
  harness.input<BallPos>().field = {1, 0};
  EXPECT_NEAR(after(0.1).kickDistance, 5.5, 0.1);
  harness.input<BallPos>().relativeVelocity = {0, 3};
  EXPECT_NEAR(after(0.1).kickDistance, 5.5, 0.1);
}

TEST_F(OppAnalyzerTest, aBallThatAMateTouchedIsNoKickOfTheirs) {
  add(false, 2, {0.2, 0});
  add(true, 3, {-0.2, 0});
  after(0.1);
  harness.input<BallPos>().relativeVelocity = {0, 6};
  harness.input<BallPos>().field = {1, 0};
  EXPECT_EQ(after(0.1).kickDistance, 0);
}

}  // namespace
