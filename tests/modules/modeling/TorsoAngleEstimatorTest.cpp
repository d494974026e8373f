#include "modules/modeling/TorsoAngleEstimator.h"

#include <gtest/gtest.h>

#include "modules/simspark/PolarPointOf.h"
#include "support/ModuleHarness.h"
#include "support/SyntheticImage.h"

namespace plumbline {
namespace {

constexpr double headHeight = 0.54;

class TorsoAngleEstimatorTest : public testing::Test {
protected:
  TorsoAngleEstimatorTest() {
    harness.input<FKModel>().T_torso_head = translation(0, 0, 0.15);
    harness.input<PolarLinePercept>();
  }
  /// Field lines as a torso sees them that leans forward by this.
  void seeGround(double pitch) {
    const Pose3 T_ground_head = translation(0, 0, headHeight) * rotationY(pitch);
    for (const auto& line :
         test::SyntheticImage().see(test::onField(Pose2(-5, 0, 0)) * T_ground_head).lines) {
      PolarLine seen;
      seen.a = polarPointOf(line.a);
      seen.b = polarPointOf(line.b);
      harness.input<PolarLinePercept>().lines.push_back(seen);
    }
  }
  test::ModuleHarness<TorsoAngleEstimator> harness;
  FrameInfo& frame = harness.input<FrameInfo>();
  SensorData& sensors = harness.input<SensorData>();
  const TorsoAngles& angles = harness.output<TorsoAngles>();
};

TEST_F(TorsoAngleEstimatorTest, aRobotAtRestHasTheTiltOfItsAccelerometer) {
  sensors.acc = 9.81 * (rotationY(0.2) * rotationX(-0.1)).linear().row(2);
  harness.cycle(100);
  EXPECT_NEAR(angles.pitch, 0.2, 1e-6);
  EXPECT_NEAR(angles.roll, -0.1, 1e-6);
  const Vec3 up = sensors.acc / 9.81;
  EXPECT_TRUE(harness.output<UprightVec>().up.isApprox(up, 1e-6));
}

TEST_F(TorsoAngleEstimatorTest, theGyroscopeTurnsItAndARestartForgets) {
  harness.cycle();
  sensors.gyro = Vec3(0, 0, 1);
  harness.cycle(50);
  EXPECT_NEAR(angles.heading, 1, 1e-4);
  frame.restarted = true;
  sensors.gyro.setZero();
  harness.cycle();
  EXPECT_EQ(angles.heading, 0);
}

TEST_F(TorsoAngleEstimatorTest, theSeenGroundCorrectsAWrongTilt) {
  // While it walks the accelerometer says little: the estimate begins upright and is 0.05 rad off.
  seeGround(0.05);
  sensors.gyro = Vec3(0, 0, 1e-9);
  for (int i = 0; i < 30; ++i) {
    sensors.acc = Vec3(i % 2 == 0 ? 3 : -3, 0, 9.81);
    harness.cycle();
  }
  EXPECT_NEAR(angles.pitch, 0.05, 0.005);
}

TEST_F(TorsoAngleEstimatorTest, aSingleLineShowsNoPlane) {
  PolarLine line;
  line.a.distance = line.b.distance = 2;
  line.a.elevation = line.b.elevation = -0.6;
  harness.input<PolarLinePercept>().lines = {line};
  harness.cycle(30);
  EXPECT_NEAR(angles.pitch, 0, 1e-9);
}

}  // namespace
}  // namespace plumbline
