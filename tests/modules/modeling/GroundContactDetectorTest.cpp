#include "modules/modeling/GroundContactDetector.h"

#include <gtest/gtest.h>

#include <cmath>

#include "support/ModuleHarness.h"
#include "support/ScratchFolder.h"
#include "support/Thrown.h"

namespace plumbline {
namespace {

class GroundContactDetectorTest : public testing::Test {
protected:
  GroundContactDetectorTest() { harness.module().timeConstant = 0; }
  static void press(FootForceData& sensor, double newtons) {
    sensor.contact = newtons != 0;
    sensor.force = Vec3(5, 0, newtons);
  }
  test::ModuleHarness<GroundContactDetector> harness;
  FrameInfo& frame = harness.input<FrameInfo>();
  SensorData& sensors = harness.input<SensorData>();
  const GroundContactState& state = harness.output<GroundContactState>();
};

TEST_F(GroundContactDetectorTest, aFootTouchesFromSixNewtonsAndLeavesBelowTwo) {
  for (const auto& [newtons, touches] :
       {std::pair(5.9, false), {6.1, true}, {2.1, true}, {1.9, false}, {5.9, false}}) {
    press(sensors.leftFoot, newtons);
    harness.cycle();
    EXPECT_EQ(state.leftContact, touches) << newtons;
    EXPECT_EQ(state.contact, touches);
    EXPECT_FALSE(state.rightContact);
  }
}

TEST_F(GroundContactDetectorTest, soleAndToesCarryTogether) {
  press(sensors.rightFoot, 4);
  press(sensors.rightToe, 4);
  harness.cycle();
  EXPECT_EQ(state.rightLoad, 8);
  EXPECT_TRUE(state.rightContact);
  press(sensors.rightToe, -10);
  harness.cycle();
  EXPECT_EQ(state.rightLoad, 0) << "a force that pulls is none";
}

TEST_F(GroundContactDetectorTest, theLoadIsSmoothedAndARestartForgetsIt) {
  harness.module().timeConstant = 0.03;
  frame.cycleSeconds = 0.03;
  press(sensors.leftFoot, 10);
  harness.cycle();
  EXPECT_NEAR(state.leftLoad, 10 * (1 - std::exp(-1)), 1e-9);
  EXPECT_TRUE(state.leftContact);
  press(sensors.leftFoot, 0);
  frame.restarted = true;
  harness.cycle();
  EXPECT_EQ(state.leftLoad, 0);
  EXPECT_FALSE(state.contact);
}

TEST(GroundContactDetector, refusesToReleaseAboveTheContact) {
  test::ScratchFolder folder;
  folder.write("GroundContactDetector.yaml", "releaseLoad: 7\n");
  test::ModuleHarness<GroundContactDetector> harness({folder.path()});
  EXPECT_EQ(thrownBy([&] { harness.module(); }),
            folder / "GroundContactDetector.yaml" + ":1: releaseLoad must not be above contactLoad");
}

}  // namespace
}  // namespace plumbline
