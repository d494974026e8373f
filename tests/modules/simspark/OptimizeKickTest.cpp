#include "modules/simspark/OptimizeKick.h"

#include <gtest/gtest.h>

#include <cmath>
#include <memory>

#include "math/Angle.h"
#include "modules/simspark/FakeServer.h"
#include "modules/simspark/Monitor.h"
#include "support/ModuleHarness.h"

namespace plumbline {
namespace {

/// A trainer's port that takes commands; the test plays robot and ball.
class OptimizeKickTest : public testing::Test {
protected:
  OptimizeKickTest() {
    monitor->setServer("127.0.0.1", server.port());
    harness.objects().set(monitor);
    harness.input<FrameInfo>().cycleSeconds = 0.1;
    truth.valid = true;
    player.number = 3;
    trial.open = true;
    trial.number = 0;
    trial.spread = 0;
    motion.ball = {0.2, -0.05};
    robotAt(Pose2(-10, 5, 0));
  }
  void robotAt(const Pose2& place) {
    truth.T_field_torso = translation(place.x(), place.y(), 0.38) * rotationZ(place.heading);
  }
  void ballAt(double x, double y) { truth.ball = Vec3(x, y, 0.042); }
  /// Until the ball lies before the robot, which begins to kick.
  void begin() {
    harness.cycle();
    server.accept();
    for (int i = 0; i < 4; ++i) commands.push_back(server.receive());
    harness.cycle(9);
    commands.push_back(server.receive());
    ballAt(-9.8, 4.95);
    harness.cycle(2);
  }
  /// The motion is selected and ends after so many cycles.
  void kick(int cycles) {
    selection.motion = SearchedMotionOutput::name;
    motion.finished = false;
    harness.cycle(static_cast<std::size_t>(cycles) - 1);
    motion.finished = true;
    harness.cycle();
    selection.motion = Motion::stand;
  }

  test::FakeServer server;
  std::shared_ptr<Monitor> monitor = std::make_shared<Monitor>();
  test::ModuleHarness<OptimizeKick> harness;
  GroundTruth& truth = harness.input<GroundTruth>();
  PlayerInfo& player = harness.input<PlayerInfo>();
  FallState& fall = harness.input<FallState>();
  OptimizationTrial& trial = harness.input<OptimizationTrial>();
  MotionSelection& selection = harness.input<MotionSelection>();
  SearchedMotionOutput& motion = harness.input<SearchedMotionOutput>();
  const MotionRequest& request = harness.output<MotionRequest>();
  const OptimizationResult& result = harness.output<OptimizationResult>();
  std::vector<std::string> commands;
};

TEST_F(OptimizeKickTest, putsRobotAndBallKicksWalksAndMeasures) {
  begin();
  EXPECT_EQ(commands, (std::vector<std::string>{
                          "(time 0.000000)", "(playMode PlayOn)",
                          "(ball (pos -10.000000 -5.000000 0.042000)(vel 0.000000 0.000000 0.000000))",
                          "(agent (unum 3)(team Left)(move -10.000000 5.000000 0.400000 -90.000000))",
                          "(ball (pos -9.800000 4.950000 0.042000)(vel 0.000000 0.000000 0.000000))"}));
  EXPECT_EQ(request.motion, SearchedMotionOutput::name);
  kick(5);
  EXPECT_EQ(request.motion, Motion::walk);
  EXPECT_NEAR(request.walkVelocity.norm(), 0.3, 1e-9);
  ballAt(-6.8, 4.95 + 0.3);  // 3 m on and 0.3 m to the left
  harness.cycle(20);
  EXPECT_EQ(result.number, -1) << "the ball may still roll";
  harness.cycle(6);
  EXPECT_EQ(result.number, 0);
  EXPECT_NEAR(result.distance, 3, 1e-9);
  EXPECT_NEAR(result.direction, toDegrees(std::atan2(0.3, 3)), 1e-9);
  EXPECT_NEAR(result.time, 500, 1e-9);
  EXPECT_TRUE(result.up);
  EXPECT_EQ(request.motion, Motion::stand);
}

TEST_F(OptimizeKickTest, onTheRightSideTheCommandsAreTurnedRound) {
  player.leftSide = false;
  begin();
  EXPECT_EQ(commands[3], "(agent (unum 3)(team Right)(move 10.000000 -5.000000 0.400000 90.000000))");
  EXPECT_EQ(commands[4], "(ball (pos 9.800000 -4.950000 0.042000)(vel 0.000000 0.000000 0.000000))");
}

TEST_F(OptimizeKickTest, oneThatLiesGetsUpBeforeTheBallComes) {
  fall.posture = Posture::onFront;
  harness.cycle(100);
  EXPECT_EQ(request.motion, Motion::stand);
  EXPECT_EQ(result.number, -1);
}

TEST_F(OptimizeKickTest, aRobotThatFellAfterTheKickIsNotUp) {
  begin();
  kick(5);
  truth.T_field_torso = truth.T_field_torso * rotationY(1.2);
  harness.cycle(30);
  EXPECT_EQ(result.number, 0);
  EXPECT_FALSE(result.up);
  EXPECT_NEAR(result.error, 1.2 * 20, 1.3) << "summed over the walk";
}

TEST_F(OptimizeKickTest, withoutGroundTruthItEndsTheAgentInFiveSeconds) {
  truth.valid = false;
  harness.cycle(49);
  EXPECT_FALSE(harness.stop().requested());
  harness.cycle(3);
  EXPECT_EQ(harness.stop().exitCode(), 2);
  EXPECT_EQ(harness.stop().reason(), "the simulator sends no ground truth: start it with --ground-truth");
}

TEST_F(OptimizeKickTest, withoutATrainersPortItEndsTheAgent) {
  {
    test::FakeServer gone;
    monitor->setServer("127.0.0.1", gone.port());
  }
  harness.cycle();
  EXPECT_TRUE(
      harness.stop().reason().starts_with("no trainer command reaches the simulator: cannot connect to "))
      << harness.stop().reason();
}

}  // namespace
}  // namespace plumbline
