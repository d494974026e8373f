#include "modules/behavior/BeforeKickOff.h"

#include <gtest/gtest.h>

#include "support/ModuleHarness.h"

using namespace plumbline;

namespace {

struct BeforeKickOffTest : testing::Test {
  const BehaviorOutput& at(double time, TeamPlayMode mode, int number = 1) {
    harness.input<FrameInfo>().time = time;
    harness.input<GameState>().playMode = mode;
    harness.input<PlayerInfo>().number = number;
    harness.cycle();
    return harness.output<BeforeKickOffOutput>();
  }
  test::ModuleHarness<BeforeKickOff> harness;
};

TEST_F(BeforeKickOffTest, beamsForHalfASecondAndThenWaits) {
  EXPECT_TRUE(at(10.0, TeamPlayMode::beforeKickOff).beam);
  EXPECT_NEAR(at(10.2, TeamPlayMode::beforeKickOff).beamPose.x(), -0.5, 1e-12);
  EXPECT_TRUE(at(10.5, TeamPlayMode::beforeKickOff).beam);
  EXPECT_FALSE(at(10.6, TeamPlayMode::beforeKickOff).beam);
  EXPECT_EQ(at(10.7, TeamPlayMode::beforeKickOff).skill, Skill::stand);
}

TEST_F(BeforeKickOffTest, isSilentInPlayAndBeamsAgainAfterAGoal) {
  EXPECT_TRUE(at(1, TeamPlayMode::beforeKickOff).active);
  EXPECT_FALSE(at(2, TeamPlayMode::playOn).active);
  EXPECT_TRUE(at(30, TeamPlayMode::goalOwn).beam);
  EXPECT_TRUE(at(30.02, TeamPlayMode::goalOpponent).beam);
}

TEST_F(BeforeKickOffTest, beamsAgainOnANewSimulator) {
  at(10, TeamPlayMode::beforeKickOff);
  EXPECT_FALSE(at(20, TeamPlayMode::beforeKickOff).beam);
  harness.input<FrameInfo>().restarted = true;
  EXPECT_TRUE(at(0.1, TeamPlayMode::beforeKickOff).beam);
}

TEST_F(BeforeKickOffTest, everyNumberHasItsPlace) {
  EXPECT_NEAR(at(0, TeamPlayMode::beforeKickOff, 11).beamPose.x(), -14, 1e-12);
  EXPECT_NEAR(at(0, TeamPlayMode::beforeKickOff, 2).beamPose.y(), 2, 1e-12);
}

TEST_F(BeforeKickOffTest, aloneANumberHasAnotherPlaceThanInATeam) {
  harness.input<PlayerRole>().members = 1;
  const double alone = at(0, TeamPlayMode::beforeKickOff, 2).beamPose.y();
  EXPECT_NEAR(alone, 2, 1e-12) << "as without a role";
  harness.input<PlayerRole>().members = 11;
  EXPECT_NE(at(0.02, TeamPlayMode::beforeKickOff, 2).beamPose.y(), alone);
}

TEST_F(BeforeKickOffTest, onlyPlayersNearTheMiddleStandOnTheRingAndOnlyAtTheOpponentsKickOff) {
  harness.input<PlayerRole>().members = 11;
  // The right team has no kick-off in the first half; number 2 would stand at (-0.2, 0.4), 0.447 m away.
  harness.input<PlayerInfo>().leftSide = false;
  const Vec2 onRing = at(0, TeamPlayMode::beforeKickOff, 2).beamPose.position;
  EXPECT_NEAR(onRing.x(), -1.0733, 1e-4);
  EXPECT_NEAR(onRing.y(), 2.1466, 1e-4);
  EXPECT_EQ(at(0, TeamPlayMode::beforeKickOff, 1).beamPose.position, Vec2(-14.4, 0)) << "far away";
  harness.input<PlayerInfo>().leftSide = true;
  EXPECT_EQ(at(0, TeamPlayMode::beforeKickOff, 2).beamPose.position, Vec2(-0.2, 0.4)) << "kicks off";
  EXPECT_EQ(at(0, TeamPlayMode::beforeKickOff, 1).beamPose.position, Vec2(-14.4, 0));
}

}  // namespace
