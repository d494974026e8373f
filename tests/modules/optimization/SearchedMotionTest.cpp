#include "modules/optimization/SearchedMotion.h"

#include <gtest/gtest.h>

#include "math/Angle.h"
#include "motion/KeyframeReader.h"
#include "motion/SearchedKick.h"
#include "simspark/LeagueRobots.h"
#include "support/ModuleHarness.h"
#include "support/ScratchFolder.h"

namespace plumbline {
namespace {

/// A trial of a kick of one keyframe and one joint.
class SearchedMotionTest : public testing::Test {
protected:
  SearchedMotionTest() {
    folder.write("motions/kick.yaml",
                 "ball: [0.2, -0.05]\nkick: {distance: 3}\nkeyframes:\n  - {time: 0.2, RHipPitch: -20}\n");
    folder.write("motions/bow.yaml", "keyframes:\n  - {time: 0.2, RHipPitch: -20}\n");
    robot.model = simsparkRobot(0);
    robot.name = robot.model.name;
    harness.input<FrameInfo>().cycleSeconds = 0.1;
    trial.open = true;
    trial.number = 0;
    trial.task = "kick";
    trial.options = {"motion=kick"};
    trial.parameters = begun(Side::right);
  }
  /// The numbers that the search begins with.
  std::vector<double> begun(Side foot) const {
    const auto motions = motion::readMotions({folder / "motions"}, robot.model);
    const motion::SearchedKick kick(*findMotion(motions, "kick"), robot.model, foot);
    std::vector<double> values;
    for (const motion::SearchedNumber& number : kick.list()) values.push_back(number.start);
    return values;
  }
  void play(int cycles) {
    selection.motion = SearchedMotionOutput::name;
    selection.started = true;
    for (int i = 0; i < cycles; ++i) {
      harness.cycle();
      selection.started = false;
    }
  }
  std::string stopped() { return harness.stop().exitCode() == 2 ? harness.stop().reason() : "runs on"; }
  test::ScratchFolder folder;
  test::ModuleHarness<SearchedMotion> harness{{folder.path()}};
  RobotDescription& robot = harness.input<RobotDescription>();
  OptimizationTrial& trial = harness.input<OptimizationTrial>();
  MotionSelection& selection = harness.input<MotionSelection>();
  const SearchedMotionOutput& output = harness.output<SearchedMotionOutput>();
};

TEST_F(SearchedMotionTest, playsTheKickWithTheTrialsNumbers) {
  trial.parameters[trial.parameters.size() - 2] = 150;
  play(1);
  EXPECT_FALSE(output.finished);
  play(2);
  EXPECT_TRUE(output.finished);
  EXPECT_NEAR(output.targets.angles[rHipPitch], fromDegrees(-20), 0.02);
  EXPECT_NEAR((output.ball - Vec2(0.15, -0.05)).norm(), 0, 1e-12) << "the place of the ball is searched, too";
}

TEST_F(SearchedMotionTest, theNextTrialIsTakenByItsNumber) {
  play(1);
  trial.parameters[trial.parameters.size() - 2] = 150;
  play(1);
  EXPECT_NEAR(output.ball.x(), 0.2, 1e-12);
  trial.number = 1;
  play(1);
  EXPECT_NEAR(output.ball.x(), 0.15, 1e-12);
}

TEST_F(SearchedMotionTest, theLeftFootKicksInTheMirrorImage) {
  trial.options.emplace_back("side=left");
  trial.parameters = begun(Side::left);
  play(2);
  EXPECT_NEAR(output.targets.angles[lHipPitch], fromDegrees(-20), 0.02);
  EXPECT_NEAR(output.ball.y(), 0.05, 1e-12);
}

TEST_F(SearchedMotionTest, withoutATrialItStands) {
  trial.open = false;
  play(2);
  EXPECT_TRUE(output.finished);
  EXPECT_FALSE(output.targets.set[rHipPitch]);
}

TEST_F(SearchedMotionTest, playsAStandUpOfTheTaskStandUp) {
  trial.task = "standUp";
  trial.options = {"motion=bow"};
  trial.parameters.clear();
  const auto motions = motion::readMotions({folder / "motions"}, robot.model);
  const motion::MotionParameters numbers(*findMotion(motions, "bow"), robot.model);
  for (const motion::SearchedNumber& one : numbers.list()) trial.parameters.push_back(one.start);
  play(3);
  EXPECT_TRUE(output.finished);
  EXPECT_NEAR(output.targets.angles[rHipPitch], fromDegrees(-20), 0.02);
}

TEST_F(SearchedMotionTest, whatCannotBeTriedEndsTheAgent) {
  trial.options = {"motion=kik"};
  harness.cycle();
  EXPECT_EQ(stopped(), "there is no motion kik in motions/; did you mean \"kick\"?");
}

TEST_F(SearchedMotionTest, aMotionWithoutABallIsNoKick) {
  trial.options = {"motion=bow"};
  harness.cycle();
  EXPECT_EQ(stopped(), "bow is no kick: it has no ball");
}

TEST_F(SearchedMotionTest, theNumbersMustBeAsMany) {
  const std::size_t count = trial.parameters.size();
  trial.parameters.pop_back();
  harness.cycle();
  EXPECT_EQ(stopped(), "the optimiser has " + std::to_string(count - 1) +
                           " parameters, the motion kick has " + std::to_string(count));
}

}  // namespace
}  // namespace plumbline
