#include "modules/simspark/OptimizeMotion.h"

#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <memory>

#include "math/Angle.h"
#include "modules/optimization/AgentTask.h"
#include "modules/simspark/FakeServer.h"
#include "modules/simspark/Monitor.h"
#include "support/ModuleHarness.h"

namespace plumbline {
namespace {

/// A trainer's port that takes commands; the test plays robot and ball.
struct PlayedKick {
  PlayedKick() {
    monitor->setServer("127.0.0.1", server.port());
    harness.objects().set(monitor);
    harness.input<FrameInfo>().cycleSeconds = 0.1;
    truth.valid = true;
    player.number = 3;
    trial.open = true;
    trial.number = 0;
    trial.task = "kick";
    trial.options = {"spread=0"};
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
  double figure(const std::string& name) const {
    for (std::size_t i = 0; i < result.figures.size(); ++i)
      if (result.figures[i] == name) return result.values[i];
    ADD_FAILURE() << "no figure " << name;
    return 0;
  }

  test::FakeServer server;
  std::shared_ptr<Monitor> monitor = std::make_shared<Monitor>();
  test::ModuleHarness<OptimizeMotion> harness;
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

class OptimizeMotionTest : public testing::Test, protected PlayedKick {};

TEST_F(OptimizeMotionTest, putsRobotAndBallKicksWalksAndMeasures) {
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
  EXPECT_NEAR(figure("distance"), 3, 1e-9);
  EXPECT_NEAR(figure("direction"), toDegrees(std::atan2(0.3, 3)), 1e-9);
  EXPECT_NEAR(figure("time"), 500, 1e-9);
  EXPECT_EQ(figure("up"), 1);
  EXPECT_EQ(request.motion, Motion::stand);
}

TEST_F(OptimizeMotionTest, aKickAsideIsPutSoThatTheBallGoesAlongTheFieldAndJudgedInItsDirection) {
  trial.options.emplace_back("direction=30");
  harness.cycle();
  server.accept();
  for (int i = 0; i < 4; ++i) commands.push_back(server.receive());
  EXPECT_EQ(commands[3], "(agent (unum 3)(team Left)(move -10.000000 5.000000 0.400000 -120.000000))");
  robotAt(Pose2(-10, 5, fromDegrees(-30)));
  harness.cycle(9);
  const Vec2 ball = Pose2(-10, 5, fromDegrees(-30)) * motion.ball;
  ballAt(ball.x(), ball.y());
  harness.cycle(2);
  kick(5);
  ballAt(ball.x() + 4, ball.y());
  harness.cycle(30);
  EXPECT_NEAR(figure("distance"), 4, 1e-9);
  EXPECT_NEAR(figure("direction"), 30, 1e-9);
  EXPECT_NEAR(figure("off"), 0, 1e-9);
}

TEST_F(OptimizeMotionTest, theWalkLastsAsLongAsTheTaskSays) {
  trial.options.emplace_back("walk=0.8");
  begin();
  kick(5);
  truth.T_field_torso = truth.T_field_torso * rotationY(0.1);
  harness.cycle(7);
  EXPECT_EQ(request.motion, Motion::walk);
  harness.cycle();
  EXPECT_EQ(request.motion, Motion::stand);
  harness.cycle(10);
  EXPECT_NEAR(figure("error"), 0.1 * 8, 1e-9);
}

TEST_F(OptimizeMotionTest, itStandsInsteadOfWalkingWhereTheTaskSaysSo) {
  trial.options.emplace_back("still=1");
  begin();
  kick(5);
  EXPECT_EQ(request.motion, Motion::stand);
  harness.cycle(19);
  EXPECT_EQ(result.number, -1);
  harness.cycle(8);
  EXPECT_EQ(result.number, 0);
}

/// What is asked of the robot, and what comes out, in a try with the option. All happens that may be judged:
/// the ball flies over a goal's bar to 5 m, and the robot leans.
std::string whatHappens(const std::string& option) {
  PlayedKick played;
  played.trial.options = {"ceiling=0.5"};
  if (!option.empty()) played.trial.options.push_back(option);
  played.begin();
  played.kick(5);
  played.truth.T_field_torso = played.truth.T_field_torso * rotationY(0.1);
  played.truth.ball = Vec3(-6, 5, 1);
  std::string text = played.request.motion;
  played.harness.cycle(15);
  played.ballAt(-5, 4.8);
  played.harness.cycle(30);
  EXPECT_EQ(played.result.number, 0);
  for (const std::string& command : played.commands) text += ' ' + command;
  return text + ' ' + std::to_string(played.result.cost);
}

TEST(OptimizeMotion, everyOptionThatAnAgentHeedsMakesADifference) {
  const std::map<std::string_view, std::string> others = {
      {"direction", "0.5"}, {"distance", "5"},  {"weight", "1"}, {"steady", "9"},
      {"ceiling", "0.6"},   {"spread", "0.02"}, {"walk", "0.8"}, {"still", "1"}};
  const std::string usual = whatHappens("");
  for (const std::string_view name : AgentTask::heeded("kick")) {
    if (name == "type" || name == "motion" || name == "side") continue;  // OptimizationClient, SearchedMotion
    ASSERT_TRUE(others.contains(name)) << name << ": which value makes a difference?";
    EXPECT_NE(whatHappens(std::string(name) + '=' + others.at(name)), usual) << name;
  }
}

TEST_F(OptimizeMotionTest, onTheRightSideTheCommandsAreTurnedRound) {
  player.leftSide = false;
  begin();
  EXPECT_EQ(commands[3], "(agent (unum 3)(team Right)(move 10.000000 -5.000000 0.400000 90.000000))");
  EXPECT_EQ(commands[4], "(ball (pos 9.800000 -4.950000 0.042000)(vel 0.000000 0.000000 0.000000))");
}

TEST_F(OptimizeMotionTest, oneThatLiesGetsUpBeforeTheBallComes) {
  fall.posture = Posture::onFront;
  harness.cycle(100);
  EXPECT_EQ(request.motion, Motion::stand);
  EXPECT_EQ(result.number, -1);
}

TEST_F(OptimizeMotionTest, aRobotThatFellAfterTheKickIsNotUp) {
  begin();
  kick(5);
  truth.T_field_torso = truth.T_field_torso * rotationY(1.2);
  harness.cycle(30);
  EXPECT_EQ(result.number, 0);
  EXPECT_EQ(figure("up"), 0);
  EXPECT_NEAR(figure("error"), 1.2 * 20, 1.3) << "summed over the walk";
}

TEST_F(OptimizeMotionTest, aRobotThatFallsDoesNotStandUpBeforeItsTryIsOver) {
  begin();
  EXPECT_TRUE(request.staysDown);
  kick(5);
  harness.cycle(19);
  EXPECT_TRUE(request.staysDown);
  harness.cycle(2);
  EXPECT_FALSE(request.staysDown);
}

/// A try of standing up until the motion begins.
class OptimizeStandUpTest : public OptimizeMotionTest {
protected:
  void lie(const std::string& direction, Posture posture, const std::string& still = "0") {
    trial.task = "standUp";
    trial.options = {"weight=0.03", "direction=" + direction, "still=" + still};
    harness.cycle();
    server.accept();
    harness.cycle(9);
    EXPECT_EQ(request.motion, FallOverOutput::name);
    EXPECT_TRUE(request.staysDown);
    truth.T_field_torso = truth.T_field_torso * rotationY(1.5);
    fall.posture = posture;
    harness.cycle(6);
  }
};

TEST_F(OptimizeStandUpTest, fallsPlaysTheMotionWalksAndMeasures) {
  lie("front", Posture::onFront);
  EXPECT_EQ(request.motion, SearchedMotionOutput::name);
  robotAt(Pose2(-10, 5, 0));
  kick(7);
  fall.posture = Posture::upright;
  EXPECT_EQ(request.motion, Motion::walk);
  truth.T_field_torso = truth.T_field_torso * rotationY(0.1);
  harness.cycle(21);
  EXPECT_EQ(result.number, 0);
  EXPECT_EQ(result.figures, (std::vector<std::string>{"time", "error", "up"}));
  EXPECT_NEAR(figure("time"), 700, 1e-9);
  EXPECT_NEAR(figure("error"), 0.1 * 20, 1e-9);
  EXPECT_EQ(figure("up"), 1);
  EXPECT_NEAR(result.cost, 0.1 * 20 + 0.03 * 700, 1e-9);
}

TEST_F(OptimizeStandUpTest, itStandsInsteadOfWalkingWhereTheTaskSaysSo) {
  lie("front", Posture::onFront, "1");
  kick(7);
  EXPECT_EQ(request.motion, Motion::stand);
  EXPECT_TRUE(request.staysDown) << "its try goes on";
}

TEST_F(OptimizeStandUpTest, aRobotThatFellTheOtherWayFallsOnceMore) {
  lie("back", Posture::onFront);
  EXPECT_EQ(request.motion, FallOverOutput::name);
  harness.cycle(40);
  EXPECT_EQ(request.motion, Motion::stand) << "it was put onto its feet";
  EXPECT_EQ(result.number, -1);
}

TEST_F(OptimizeMotionTest, withoutGroundTruthItEndsTheAgentInFiveSeconds) {
  truth.valid = false;
  harness.cycle(49);
  EXPECT_FALSE(harness.stop().requested());
  harness.cycle(3);
  EXPECT_EQ(harness.stop().exitCode(), 2);
  EXPECT_EQ(harness.stop().reason(), "the simulator sends no ground truth: start it with --ground-truth");
}

TEST_F(OptimizeMotionTest, withoutATrainersPortItEndsTheAgent) {
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
