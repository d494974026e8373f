#include "modules/evaluation/GroundtruthModule.h"

#include <gtest/gtest.h>

#include "math/Angle.h"
#include "support/LogLines.h"
#include "support/ModuleHarness.h"

namespace plumbline {
namespace {

class GroundtruthModuleTest : public testing::Test {
protected:
  GroundtruthModuleTest() {
    truth.valid = true;
    truth.T_field_torso = translation(2, 3, 0.4) * rotationZ(pi / 2) * rotationY(0.3);
    truth.ball = Vec3(2, 5, 0.04);
  }
  test::ModuleHarness<GroundtruthModule> harness;
  FrameInfo& frame = harness.input<FrameInfo>();
  GroundTruth& truth = harness.input<GroundTruth>();
  const RobotPose& pose = harness.output<RobotPose>();
  const BallPos& ball = harness.output<BallPos>();
};

TEST_F(GroundtruthModuleTest, givesTheTruePoseAndBall) {
  harness.cycle();
  EXPECT_TRUE(pose.valid);
  EXPECT_NEAR((pose.pose.position - Vec2(2, 3)).norm(), 0, 1e-12);
  EXPECT_NEAR(pose.pose.heading, pi / 2, 1e-12) << "whatever its lean";
  EXPECT_EQ(pose.positionDeviation, 0);
  EXPECT_TRUE(ball.valid);
  EXPECT_EQ(ball.age, 0);
  EXPECT_EQ(ball.field, Vec2(2, 5));
  EXPECT_NEAR((ball.relative - Vec2(2, 0)).norm(), 0, 1e-12);
}

TEST_F(GroundtruthModuleTest, theBallsSpeedIsItsWayInACycle) {
  harness.cycle();
  EXPECT_EQ(ball.relativeVelocity, Vec2(0, 0)) << "not known yet";
  truth.ball.y() += 0.02;
  frame.cycleSeconds = 0.02;
  harness.cycle();
  EXPECT_NEAR((ball.relativeVelocity - Vec2(1, 0)).norm(), 0, 1e-9);
}

TEST_F(GroundtruthModuleTest, withoutTheTruthNothingIsValidAndThatIsToldOnce) {
  truth.valid = false;
  test::LogLines log;
  harness.cycle(3);
  EXPECT_FALSE(pose.valid);
  EXPECT_FALSE(ball.valid);
  EXPECT_EQ(ball.age, 1e3);
  EXPECT_EQ(log.lines, std::vector<std::string>{
                           "warning: no ground truth: start the simulator with its ground truth option"});
}

TEST_F(GroundtruthModuleTest, afterAGapOrARestartTheSpeedIsNotKnown) {
  harness.cycle();
  truth.valid = false;
  harness.cycle();
  truth.valid = true;
  truth.ball.x() = -7;
  harness.cycle();
  EXPECT_EQ(ball.relativeVelocity, Vec2(0, 0)) << "it had more than a cycle for its way";
  frame.restarted = true;
  truth.ball.x() = 7;
  harness.cycle();
  EXPECT_EQ(ball.relativeVelocity, Vec2(0, 0));
}

}  // namespace
}  // namespace plumbline
