#include "modules/motion/MotionSelector.h"

#include <gtest/gtest.h>

#include "ModuleUnderTest.h"
#include "representations/motion/KickMotionOutput.h"
#include "representations/motion/SpecialActionsOutput.h"
#include "representations/motion/StandOutput.h"
#include "representations/motion/WalkingEngineOutput.h"
#include "simspark/LeagueRobots.h"

namespace plumbline {
namespace {

/// A motion that no file of the project names.
REPRESENTATION_OF(BowOutput, MotionOutput)
class BowOutput : public BowOutputBase {
public:
  BowOutput() : BowOutputBase("bow") {}
};

struct Selector : public MotionSelector {
  using MotionSelector::allMotionOutputs;
  using MotionSelector::standUp;
  using MotionSelector::theFallState;
  using MotionSelector::theFrameInfo;
  using MotionSelector::theMotionRequest;
  using MotionSelector::theRobotDescription;
};

class MotionSelectorTest : public testing::Test {
protected:
  MotionSelectorTest() : selector("MotionSelector", {"config", "config/robots/simspark_type0"}) {
    selector->theFrameInfo = &frame;
    selector->theMotionRequest = &request;
    selector->theFallState = &fall;
    selector->theRobotDescription = &robot;
    selector->allMotionOutputs = {&stand, &walk, &special, &kick, &bow};
    stand.fadeSeconds = 0.14;
    walk.fadeSeconds = 0.06;
  }
  void cycle() {
    selector->update(&selection);
    double sum = 0;
    for (const double ratio : selection.ratios) sum += ratio;
    EXPECT_NEAR(sum, 1, 1e-12);
  }
  double ratio(const std::string& motion) const { return selection.ratio(motion); }

  ModuleUnderTest<Selector> selector;
  FrameInfo frame;
  MotionRequest request;
  FallState fall;
  RobotDescription robot;
  StandOutput stand;
  WalkingEngineOutput walk;
  SpecialActionsOutput special;
  KickMotionOutput kick;
  BowOutput bow;
  MotionSelection selection;
};

TEST_F(MotionSelectorTest, fadesIntoTheWalkAndLeavesItOnlyStanding) {
  request.motion = Motion::walk;
  cycle();
  EXPECT_EQ(selection.motion, Motion::walk);
  EXPECT_TRUE(selection.started);
  EXPECT_NEAR(ratio(Motion::walk), 0.02 / 0.06, 1e-9);
  EXPECT_NEAR(ratio(Motion::stand), 1 - 0.02 / 0.06, 1e-9);
  cycle();
  EXPECT_FALSE(selection.started);
  cycle();
  EXPECT_NEAR(ratio(Motion::walk), 1, 1e-9);
  walk.finished = false;
  request.motion = Motion::kick;
  for (int i = 0; i < 20; ++i) cycle();
  EXPECT_EQ(selection.motion, Motion::walk) << "a step is under way";
  walk.finished = true;
  cycle();
  EXPECT_EQ(selection.motion, Motion::kick);
  EXPECT_TRUE(selection.started);
  EXPECT_DOUBLE_EQ(ratio(Motion::kick), 1) << "a kick begins at the measured angles";
}

TEST_F(MotionSelectorTest, aMotionThatIsWantedAtOnceWaitsForNoWalkButForAKick) {
  stand.finished = true;
  cycle();
  request.motion = Motion::walk;
  cycle();
  walk.finished = kick.finished = false;
  request.motion = Motion::specialAction;
  request.specialAction = "diveLeft";
  cycle();
  EXPECT_EQ(selection.motion, Motion::walk);
  request.atOnce = true;
  cycle();
  EXPECT_EQ(selection.motion, Motion::specialAction);
  EXPECT_EQ(selection.specialAction, "diveLeft");
  special.finished = true;
  request.motion = Motion::kick;
  cycle();
  ASSERT_EQ(selection.motion, Motion::kick);
  request.motion = Motion::specialAction;
  cycle();
  EXPECT_EQ(selection.motion, Motion::kick);
}

TEST_F(MotionSelectorTest, aKickIsFinishedBeforeAnythingElse) {
  request.motion = Motion::kick;
  cycle();
  kick.finished = false;
  request.motion = Motion::walk;
  for (int i = 0; i < 10; ++i) cycle();
  EXPECT_EQ(selection.motion, Motion::kick);
  kick.finished = true;
  cycle();
  EXPECT_EQ(selection.motion, Motion::walk);
  cycle();
  request.motion = Motion::kick;
  cycle();
  EXPECT_TRUE(selection.started);
  cycle();
  EXPECT_TRUE(selection.started) << "a kick that is finished and still asked for is kicked again";
}

TEST_F(MotionSelectorTest, aFallInterruptsEverything) {
  request.motion = Motion::walk;
  cycle();
  walk.finished = false;
  fall.posture = Posture::falling;
  cycle();
  EXPECT_EQ(selection.motion, Motion::walk);
  fall.posture = Posture::onFront;
  cycle();
  EXPECT_EQ(selection.motion, Motion::specialAction);
  EXPECT_EQ(selection.specialAction, "standUpFront");
  EXPECT_TRUE(selection.started);
  EXPECT_DOUBLE_EQ(ratio(Motion::specialAction), 1);
}

TEST_F(MotionSelectorTest, aRobotThatStaysDownDoesWhatIsAsked) {
  cycle();
  request.motion = "bow";
  request.staysDown = true;
  fall.posture = Posture::onBack;
  cycle();
  EXPECT_EQ(selection.motion, "bow");
  request.staysDown = false;
  cycle();
  EXPECT_EQ(selection.motion, Motion::specialAction);
}

TEST_F(MotionSelectorTest, aRobotWithoutAMotionToStandUpDoesWhatIsAsked) {
  selector->standUp.back = "";
  cycle();
  fall.posture = Posture::onBack;
  cycle();
  EXPECT_EQ(selection.motion, Motion::stand);
  fall.posture = Posture::onFront;
  cycle();
  EXPECT_EQ(selection.motion, Motion::specialAction);
}

TEST_F(MotionSelectorTest, standsUpUntilItIsUp) {
  fall.posture = Posture::onBack;
  cycle();
  EXPECT_EQ(selection.specialAction, "standUpBack");
  special.finished = false;
  fall.posture = Posture::upright;  // for a moment, on the way up
  cycle();
  fall.posture = Posture::onFront;  // and over
  cycle();
  EXPECT_EQ(selection.specialAction, "standUpBack") << "the action is played to its end";
  EXPECT_FALSE(selection.started);
  special.finished = true;
  // The torso may still swing up: half a second passes before the next try.
  for (int i = 0; i < 25; ++i) {
    cycle();
    EXPECT_NE(selection.motion, Motion::specialAction) << "cycle " << i;
  }
  cycle();
  EXPECT_EQ(selection.specialAction, "standUpFront") << "and then the right one";
  EXPECT_TRUE(selection.started);
  special.finished = false;
  cycle();
  EXPECT_FALSE(selection.started);
  special.finished = true;
  fall.posture = Posture::upright;
  cycle();
  EXPECT_EQ(selection.motion, Motion::stand);
  EXPECT_GT(ratio(Motion::specialAction), 0.5) << "the end of the action fades into the stand";
}

/// Type 0 has fast stand-ups.
TEST_F(MotionSelectorTest, triesTheFastStandUpFirstAndTheOtherOneAfterIt) {
  selector->standUp.fastBack = "standUpBackFast";
  selector->standUp.fastFront = "standUpFrontFaster";
  robot.model = simsparkRobot(0);
  robot.name = robot.model.name;
  fall.posture = Posture::onBack;
  cycle();
  EXPECT_EQ(selection.specialAction, "standUpBackFast");
  for (int i = 0; i < 30 && !selection.specialAction.empty(); ++i) cycle();
  EXPECT_EQ(selection.specialAction, "") << "over, and it waits";
  for (int i = 0; i < 30 && selection.specialAction.empty(); ++i) cycle();
  EXPECT_EQ(selection.specialAction, "standUpBack") << "it lies still, so that one has failed";
  for (int i = 0; i < 50 * 10 && selection.specialAction == "standUpBack"; ++i) cycle();
  for (int i = 0; i < 50 * 10 && selection.specialAction.empty(); ++i) cycle();
  EXPECT_EQ(selection.specialAction, "standUpBackFast") << "that one, too: not the same for ever";
  fall.posture = Posture::upright;
  for (int i = 0; i < 50 * 5; ++i) cycle();
  fall.posture = Posture::onBack;
  cycle();
  EXPECT_EQ(selection.specialAction, "standUpBackFast") << "another fall";
  for (int i = 0; i < 50; ++i) cycle();
  fall.posture = Posture::upright;
  for (int i = 0; i < 50 * 6; ++i) cycle();
  fall.posture = Posture::onFront;
  cycle();
  EXPECT_EQ(selection.specialAction, "standUpFront") << "it has no faster one";
}

/// Type 0 has fast stand-ups.
TEST_F(MotionSelectorTest, standsUpAtOnceAfterARollOffItsSide) {
  selector->standUp.fastBack = "standUpBackFast";
  robot.model = simsparkRobot(0);
  robot.name = robot.model.name;
  cycle();
  fall.posture = Posture::onLeft;
  cycle();
  EXPECT_EQ(selection.specialAction, "rollOver");
  special.finished = false;
  cycle();
  special.finished = true;
  fall.posture = Posture::onBack;
  cycle();
  EXPECT_EQ(selection.motion, Motion::specialAction);
  EXPECT_EQ(selection.specialAction, "standUpBackFast");
  EXPECT_TRUE(selection.started);
}

TEST_F(MotionSelectorTest, aRequestedActionRunsAndARestartForgetsEverything) {
  request.motion = Motion::specialAction;
  request.specialAction = "wave";
  cycle();
  EXPECT_EQ(selection.specialAction, "wave");
  special.finished = false;
  request.specialAction = "bow";
  cycle();
  EXPECT_EQ(selection.specialAction, "wave");
  special.finished = true;
  cycle();
  EXPECT_EQ(selection.specialAction, "bow");
  request.motion = Motion::stand;
  special.finished = false;
  cycle();
  EXPECT_EQ(selection.motion, Motion::specialAction);
  frame.restarted = true;
  cycle();
  EXPECT_EQ(selection.motion, Motion::stand);
}

TEST_F(MotionSelectorTest, aNewMotionFadesInAndIsLeftWhenItIsFinished) {
  bow.fadeSeconds = 0.1;
  request.motion = "bow";
  cycle();
  EXPECT_EQ(selection.motion, "bow");
  EXPECT_NEAR(ratio("bow"), 0.2, 1e-12);
  bow.finished = false;
  request.motion = Motion::walk;
  for (int i = 0; i < 10; ++i) cycle();
  EXPECT_EQ(selection.motion, "bow");
  bow.finished = true;
  cycle();
  EXPECT_EQ(selection.motion, Motion::walk);
}

TEST_F(MotionSelectorTest, standsWhereThereIsNoSuchMotion) {
  request.motion = Motion::walk;
  cycle();
  request.motion = "juggle";
  cycle();
  EXPECT_EQ(selection.motion, Motion::stand);
}

}  // namespace
}  // namespace plumbline
