#include "modules/modeling/FallDetector.h"

#include <gtest/gtest.h>

#include "math/Angle.h"
#include "support/ModuleHarness.h"

using namespace plumbline;

namespace {

/// The module with inputs of the test's own.
class Detector {
public:
  /// Tilted about the axis (1, 0: to the right; 0, 1: forward) by degrees, for so many cycles.
  void be(double aboutX, double aboutY, double degrees, int cycles, double height = 0.38) {
    const Mat3 R = Eigen::AngleAxisd(fromDegrees(degrees), Vec3(aboutX, aboutY, 0).normalized()).matrix();
    harness_.input<UprightVec>().up = R.row(2);
    harness_.input<TorsoPose>().T_ground_torso = translation(0, 0, height);
    for (int i = 0; i < cycles; ++i) {
      harness_.input<FrameInfo>().time += 0.02;
      harness_.cycle();
    }
  }
  const FallState& state() { return harness_.output<FallState>(); }

private:
  test::ModuleHarness<FallDetector> harness_;
};

TEST(FallDetector, everySideOfAFall) {
  const struct {
    double x, y;
    Posture posture;
  } cases[] = {
      {0, 1, Posture::onFront}, {0, -1, Posture::onBack}, {1, 0, Posture::onRight}, {-1, 0, Posture::onLeft}};
  for (const auto& c : cases) {
    Detector detector;
    detector.be(c.x, c.y, 10, 10);
    EXPECT_EQ(detector.state().posture, Posture::upright);
    detector.be(c.x, c.y, 40, 5);
    EXPECT_EQ(detector.state().posture, Posture::falling);
    EXPECT_FALSE(detector.state().lying());
    detector.be(c.x, c.y, 85, 4);
    EXPECT_EQ(detector.state().posture, Posture::falling) << "not for long enough";
    detector.be(c.x, c.y, 85, 4);
    EXPECT_EQ(detector.state().posture, c.posture);
    EXPECT_TRUE(detector.state().lying());
    EXPECT_EQ(detector.state().falls, 1);
    detector.be(c.x, c.y, 45, 10);
    EXPECT_EQ(detector.state().posture, c.posture) << "on its way up";
    detector.be(c.x, c.y, 15, 10);
    EXPECT_EQ(detector.state().posture, Posture::upright);
    EXPECT_EQ(detector.state().falls, 1);
  }
}

TEST(FallDetector, rollingOverIsOneFall) {
  Detector detector;
  detector.be(0, 1, 85, 10);
  detector.be(1, 0, 85, 10);
  EXPECT_EQ(detector.state().posture, Posture::onRight);
  EXPECT_EQ(detector.state().falls, 1);
}

TEST(FallDetector, aStumbleIsNoFall) {
  Detector detector;
  detector.be(0, 1, 40, 10);
  detector.be(0, 1, 5, 5);
  EXPECT_EQ(detector.state().posture, Posture::upright);
  EXPECT_EQ(detector.state().falls, 0);
}

TEST(FallDetector, aLowUprightTorsoSits) {
  Detector detector;
  detector.be(0, 1, 5, 45, 0.18);
  EXPECT_EQ(detector.state().posture, Posture::upright) << "a deep knee bend may take a second";
  detector.be(0, 1, 5, 10, 0.18);
  EXPECT_EQ(detector.state().posture, Posture::sitting);
  EXPECT_EQ(detector.state().falls, 0);
  detector.be(0, 1, 5, 2, 0.38);
  EXPECT_EQ(detector.state().posture, Posture::upright);
}

}  // namespace
