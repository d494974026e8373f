#include "modules/optimization/FallOver.h"

#include <gtest/gtest.h>

#include "simspark/LeagueRobots.h"
#include "support/ModuleHarness.h"
#include "support/Thrown.h"

namespace plumbline {
namespace {

/// A robot of type 0 with its joints at 0 that is to fall.
class FallOverTest : public testing::Test {
protected:
  FallOverTest() {
    robot.model = simsparkRobot(0);
    robot.name = robot.model.name;
    trial.task = "standUp";
    trial.number = 0;
    trial.seed = 5;
    selection.motion = FallOverOutput::name;
  }
  JointArray begun() {
    selection.started = true;
    harness.cycle();
    selection.started = false;
    return output.targets.angles;
  }
  test::ModuleHarness<FallOver> harness;
  RobotDescription& robot = harness.input<RobotDescription>();
  OptimizationTrial& trial = harness.input<OptimizationTrial>();
  MotionSelection& selection = harness.input<MotionSelection>();
  FallState& fall = harness.input<FallState>();
  const FallOverOutput& output = harness.output<FallOverOutput>();
};

TEST_F(FallOverTest, leansAtItsAnklesForwardOrBackward) {
  trial.options = {"direction=front"};
  JointArray targets = begun();
  EXPECT_LT(targets[lAnklePitch], -0.4 + 1e-9);
  EXPECT_EQ(targets[lAnklePitch], targets[rAnklePitch]);
  EXPECT_EQ(targets[lKneePitch], 0) << "the rest stands until it falls";
  trial.options = {"direction=back"};
  EXPECT_GT(begun()[lAnklePitch], 0.4 - 1e-9);
}

TEST_F(FallOverTest, whileItFallsItsJointsGoSomewhereNearTheStand) {
  begun();
  fall.posture = Posture::falling;
  harness.cycle();
  double largest = 0;
  for (const double angle : output.targets.angles) largest = std::max(largest, std::abs(angle));
  EXPECT_GT(largest, 0.1);
  EXPECT_LE(largest, harness.module().spread);
}

TEST_F(FallOverTest, theSeedSaysHowAndEachBeginningIsAnotherFall) {
  const JointArray first = begun(), second = begun();
  EXPECT_NE(first, second);
  trial.number = 1;
  EXPECT_EQ(begun(), first) << "of the same seed";
}

TEST_F(FallOverTest, movesNothingUnlessItIsSelected) {
  selection.motion = Motion::stand;
  begun();
  EXPECT_FALSE(output.targets.set[lAnklePitch]);
}

TEST_F(FallOverTest, theLeansMustBeInOrder) {
  harness.module().mostLean = 0.1;
  EXPECT_NE(thrownBy([&] { harness.module().parametersChanged(); }).find("mostLean"), std::string::npos);
}

}  // namespace
}  // namespace plumbline
