#include "modules/modeling/AugmentedSelfLocator.h"

#include <gtest/gtest.h>

#include "modules/simspark/PolarPointOf.h"
#include "support/ModuleHarness.h"
#include "support/ScratchFolder.h"
#include "support/SyntheticImage.h"
#include "support/Thrown.h"

namespace plumbline {
namespace {

/// A robot that stands and looks at the league's field.
class AugmentedSelfLocatorTest : public testing::Test {
protected:
  AugmentedSelfLocatorTest() {
    harness.input<FieldDimensions>();
    player.sideKnown = true;
    harness.input<TorsoPose>().T_ground_torso = translation(0, 0, 0.4);
    harness.input<FKModel>().T_torso_head = translation(0, 0, 0.14);
  }
  /// So many images from this place of the server's field.
  const RobotPose& lookFrom(const Pose2& place, int images) {
    for (int i = 0; i < images; ++i) {
      const simspark::See see = camera_.see(test::onField(place) * test::headOverGround());
      std::vector<PolarLandmark>& landmarks = harness.input<PolarLandmarkPercept>().landmarks;
      std::vector<PolarLine>& lines = harness.input<PolarLinePercept>().lines;
      landmarks.clear();
      for (const simspark::SeenObject& object : see.objects) {
        landmarks.emplace_back().name = object.name;
        landmarks.back().position = polarPointOf(object.position);
      }
      lines.clear();
      for (const simspark::SeenLine& line : see.lines) {
        lines.emplace_back().a = polarPointOf(line.a);
        lines.back().b = polarPointOf(line.b);
      }
      image.newImage = true;
      harness.cycle();
    }
    image.newImage = false;
    return pose;
  }
  void expectAt(const Pose2& place) {
    EXPECT_TRUE(pose.valid);
    EXPECT_LT((pose.pose.position - place.position).norm(), 0.05);
    EXPECT_NEAR(normalizeAngle(pose.pose.heading - place.heading), 0, 0.02);
  }
  test::ModuleHarness<AugmentedSelfLocator> harness;
  FrameInfo& frame = harness.input<FrameInfo>();
  PlayerInfo& player = harness.input<PlayerInfo>();
  VisionInfo& image = harness.input<VisionInfo>();
  Odometry& odometry = harness.input<Odometry>();
  const RobotPose& pose = harness.output<RobotPose>();

private:
  test::SyntheticImage camera_{5};
};

TEST_F(AugmentedSelfLocatorTest, findsItselfAndFollowsTheOdometry) {
  lookFrom(Pose2(-8, 2, 0.5), 20);
  expectAt(Pose2(-8, 2, 0.5));
  EXPECT_LT(pose.positionDeviation, 0.1);
  odometry.step = Pose2(0.1, 0, 0);
  harness.cycle(5);
  expectAt(Pose2(-8, 2, 0.5) * Pose2(0.5, 0, 0));
}

TEST_F(AugmentedSelfLocatorTest, onTheRightSideTheFieldIsTurnedRound) {
  lookFrom(Pose2(-8, 2, 0.5), 20);
  player.leftSide = false;
  lookFrom(Pose2(-8, 2, 0.5), 20);
  expectAt(Pose2(8, -2, 0.5 + pi));
}

TEST_F(AugmentedSelfLocatorTest, itIsValidOnlyOnceTheSideIsKnown) {
  player.sideKnown = false;
  EXPECT_FALSE(lookFrom(Pose2(-8, 2, 0.5), 20).valid);
  player.sideKnown = true;
  harness.cycle();
  EXPECT_TRUE(pose.valid);
}

TEST_F(AugmentedSelfLocatorTest, aRestartForgetsThePlace) {
  lookFrom(Pose2(-8, 2, 0.5), 20);
  frame.restarted = true;
  harness.cycle();
  EXPECT_FALSE(pose.valid);
  frame.restarted = false;
  lookFrom(Pose2(5, -4, -2), 20);
  expectAt(Pose2(5, -4, -2));
}

TEST_F(AugmentedSelfLocatorTest, withoutAnImageAndWithUnknownFlagsItIsNowhere) {
  harness.cycle(5);
  EXPECT_FALSE(pose.valid);
  harness.input<PolarLandmarkPercept>().landmarks.emplace_back().name = "F9L";
  image.newImage = true;
  harness.cycle(5);
  EXPECT_FALSE(pose.valid);
}

TEST(AugmentedSelfLocator, refusesRatesThatNeverDrawFromAnImage) {
  test::ScratchFolder folder;
  folder.write("AugmentedSelfLocator.yaml", "filter: {slowRate: 0.5}\n");
  test::ModuleHarness<AugmentedSelfLocator> harness({folder.path()});
  EXPECT_EQ(thrownBy([&] { harness.module(); }),
            "AugmentedSelfLocator.filter.fastRate must not be below filter.slowRate");
}

}  // namespace
}  // namespace plumbline
