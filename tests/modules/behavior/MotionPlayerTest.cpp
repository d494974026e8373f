#include "modules/behavior/MotionPlayer.h"

#include <gtest/gtest.h>

#include "robot/RobotModel.h"
#include "simspark/LeagueRobots.h"
#include "support/ModuleHarness.h"
#include "support/Thrown.h"

namespace plumbline {
namespace {

class MotionPlayerTest : public testing::Test {
protected:
  explicit MotionPlayerTest(bool once = false) {
    harness.objects().set(std::make_shared<MotionToPlay>(MotionToPlay{"wave", once}));
    harness.objects().set(std::make_shared<RobotModel>(simsparkRobot(0)));
    harness.input<FrameInfo>().cycleSeconds = 0.1;
    harness.input<FallState>();
  }
  bool asks() const { return request.motion == Motion::specialAction && request.specialAction == "wave"; }
  /// What the selector and the player of keyframes say after a cycle in which the motion runs or has ended.
  void motionIs(bool finished) {
    selection.motion = Motion::specialAction;
    selection.specialAction = "wave";
    special.finished = finished;
  }

  test::ModuleHarness<MotionPlayer> harness;
  MotionSelection& selection = harness.input<MotionSelection>();
  SpecialActionsOutput& special = harness.input<SpecialActionsOutput>();
  const MotionRequest& request = harness.output<MotionRequest>();
};

class MotionPlayerOnce : public MotionPlayerTest {
protected:
  MotionPlayerOnce() : MotionPlayerTest(true) {}
};

TEST_F(MotionPlayerTest, standsPlaysStandsAndPlaysAgain) {
  harness.cycle(14);
  EXPECT_EQ(request.motion, Motion::stand);
  harness.cycle(2);
  EXPECT_TRUE(asks());
  motionIs(false);
  harness.cycle(50);
  EXPECT_TRUE(asks());
  motionIs(true);
  harness.cycle(1);
  EXPECT_EQ(request.motion, Motion::stand) << "in the cycle in which its end shows, or it would begin again";
  selection.motion = Motion::stand;
  harness.cycle(16);
  EXPECT_TRUE(asks());
  EXPECT_FALSE(harness.stop().requested());
}

TEST_F(MotionPlayerTest, waitsForARobotThatLies) {
  harness.input<FallState>().posture = Posture::onBack;
  harness.cycle(100);
  EXPECT_EQ(request.motion, Motion::stand);
}

TEST_F(MotionPlayerOnce, endsTheAgentAfterTheMotion) {
  harness.cycle(20);
  motionIs(true);
  harness.cycle(1);
  EXPECT_FALSE(harness.stop().requested()) << "it stands for a moment";
  selection.motion = Motion::stand;
  harness.cycle(16);
  EXPECT_TRUE(harness.stop().requested());
  EXPECT_EQ(harness.stop().exitCode(), 0);
}

TEST(MotionPlayer, namesTheNearestMotion) {
  test::ModuleHarness<MotionPlayer> harness;
  harness.objects().set(std::make_shared<MotionToPlay>(MotionToPlay{"wavy", false}));
  harness.objects().set(std::make_shared<RobotModel>(simsparkRobot(0)));
  EXPECT_EQ(thrownBy([&] { harness.module(); }),
            "--motion wavy: there is no motion wavy in motions/; did you mean \"wave\"?");
}

}  // namespace
}  // namespace plumbline
