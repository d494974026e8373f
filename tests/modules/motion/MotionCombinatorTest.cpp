#include "modules/motion/MotionCombinator.h"

#include <gtest/gtest.h>

#include "representations/motion/DeadMotionOutput.h"
#include "representations/motion/KickMotionOutput.h"
#include "representations/motion/SpecialActionsOutput.h"
#include "representations/motion/StandOutput.h"
#include "representations/motion/WalkingEngineOutput.h"

namespace plumbline {
namespace {

struct Combinator : public MotionCombinator {
  using MotionCombinator::allMotionOutputs;
  using MotionCombinator::theHeadMotionRequest;
  using MotionCombinator::theMotionSelection;
};

class MotionCombinatorTest : public testing::Test {
protected:
  MotionCombinatorTest() {
    combinator.theMotionSelection = &selection;
    combinator.allMotionOutputs = {&stand, &walk, &special, &kick, &dead};
    selection.motions = {"stand", "walk", "specialAction", "kick", "dead"};
    combinator.theHeadMotionRequest = &head;
    head.yaw = 0.4;
    head.pitch = -0.1;
  }
  Combinator combinator;
  MotionSelection selection;
  StandOutput stand;
  WalkingEngineOutput walk;
  SpecialActionsOutput special;
  KickMotionOutput kick;
  DeadMotionOutput dead;
  HeadMotionRequest head;
  JointRequest request;
};

TEST_F(MotionCombinatorTest, mixesByTheRatios) {
  stand.targets.setTo(lKneePitch, 1.0);
  walk.targets.setTo(lKneePitch, 0.2);
  walk.targets.setTo(rKneePitch, 0.6);
  selection.motion = Motion::walk;
  selection.ratios = {0.25, 0.75, 0, 0, 0};
  combinator.update(&request);
  EXPECT_NEAR(request.targets.angles[lKneePitch], 0.4, 1e-12);
  EXPECT_NEAR(request.targets.angles[rKneePitch], 0.6, 1e-12) << "only the walk moves it";
  EXPECT_FALSE(request.targets.set[lHipPitch]);
  EXPECT_DOUBLE_EQ(request.targets.angles[headYaw], 0.4);
  EXPECT_DOUBLE_EQ(request.targets.angles[headPitch], -0.1);
}

TEST_F(MotionCombinatorTest, aJointNobodyMovesKeepsItsTarget) {
  special.targets.setTo(lShoulderPitch, 0.7);
  special.targets.setTo(headYaw, 0);
  selection.motion = Motion::specialAction;
  selection.ratios = {0, 0, 1, 0, 0};
  combinator.update(&request);
  EXPECT_DOUBLE_EQ(request.targets.angles[headYaw], 0) << "the action moves the head itself";
  EXPECT_DOUBLE_EQ(request.targets.angles[headPitch], -0.1);
  selection.motion = Motion::walk;
  selection.ratios = {0, 1, 0, 0, 0};
  combinator.update(&request);
  EXPECT_DOUBLE_EQ(request.targets.angles[lShoulderPitch], 0.7);
  EXPECT_DOUBLE_EQ(request.targets.angles[headYaw], 0.4);
}

TEST_F(MotionCombinatorTest, deadMakesSlack) {
  dead.targets.set.fill(true);
  dead.targets.stiffness.fill(0);
  selection.motion = Motion::dead;
  selection.ratios = {0, 0, 0, 0, 1};
  combinator.update(&request);
  EXPECT_DOUBLE_EQ(request.targets.stiffness[lKneePitch], 0);
}

}  // namespace
}  // namespace plumbline
