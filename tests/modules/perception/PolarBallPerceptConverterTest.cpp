#include "modules/perception/PolarBallPerceptConverter.h"

#include <gtest/gtest.h>

#include <cmath>

#include "math/Angle.h"
#include "support/ModuleHarness.h"

namespace plumbline {
namespace {

class PolarBallPerceptConverterTest : public testing::Test {
protected:
  PolarBallPerceptConverterTest() {
    harness.input<TorsoPose>().T_ground_torso = translation(0, 0, 0.4);
    harness.input<FKModel>().T_torso_head = translation(0.05, 0, 0.14);
  }
  /// The ball at this place of the head's frame.
  const BallPercept& seenAt(const Vec3& inHead) {
    ball.seen = true;
    ball.position.distance = inHead.norm();
    ball.position.azimuth = std::atan2(inHead.y(), inHead.x());
    ball.position.elevation = std::asin(inHead.z() / inHead.norm());
    harness.cycle();
    return percept;
  }
  test::ModuleHarness<PolarBallPerceptConverter> harness;
  PolarBallPercept& ball = harness.input<PolarBallPercept>();
  const BallPercept& percept = harness.output<BallPercept>();
};

TEST_F(PolarBallPerceptConverterTest, placesTheBallOnTheGround) {
  EXPECT_TRUE(seenAt(Vec3(1, 2, -0.5)).seen);
  EXPECT_NEAR((percept.position - Vec2(1.05, 2)).norm(), 0, 1e-12);
  EXPECT_NEAR(percept.height, 0.04, 1e-12);
}

TEST_F(PolarBallPerceptConverterTest, turnsWithHeadAndTorso) {
  harness.input<FKModel>().T_torso_head = translation(0, 0, 0.14) * rotationZ(pi / 2);
  harness.input<TorsoPose>().T_ground_torso = translation(0, 0, 0.4) * rotationX(-0.3);
  const Vec3 onGround = translation(0, 0, 0.4) * rotationX(-0.3) * Vec3(0, 2, 0.14);
  seenAt(Vec3(2, 0, 0));
  EXPECT_NEAR((percept.position - onGround.head<2>()).norm(), 0, 1e-12);
  EXPECT_NEAR(percept.height, onGround.z(), 1e-12);
}

TEST_F(PolarBallPerceptConverterTest, withoutABallTheLastPlaceStays) {
  seenAt(Vec3(1, 2, -0.5));
  ball = {};
  harness.cycle();
  EXPECT_FALSE(percept.seen);
  EXPECT_NEAR((percept.position - Vec2(1.05, 2)).norm(), 0, 1e-12);
}

}  // namespace
}  // namespace plumbline
