#include "modules/motion/StandMotion.h"

#include <gtest/gtest.h>

#include "simspark/LeagueRobots.h"
#include "support/ModuleHarness.h"
#include "support/ScratchFolder.h"
#include "support/Thrown.h"
#include "walking/engine/WalkEngine.h"

namespace plumbline {
namespace {

class StandMotionTest : public testing::Test {
protected:
  void robotIs(int type) {
    robot.model = simsparkRobot(type);
    robot.name = robot.model.name;
    harness.cycle();
  }
  test::ModuleHarness<StandMotion> harness{{"config", "config/robots/simspark_type0"}};
  RobotDescription& robot = harness.input<RobotDescription>();
  const StandOutput& output = harness.output<StandOutput>();
};

TEST_F(StandMotionTest, standsAsTheWalkDoesBetweenSteps) {
  robotIs(0);
  ConfigStore config({"config", "config/robots/simspark_type0"});
  walking::WalkEngine engine(walking::readWalkGaits(config.file("walking").root()), simsparkRobot(0));
  EXPECT_EQ(output.targets.angles, engine.stand().angles);
  EXPECT_GT(output.targets.angles[lKneePitch], 0.3);
  EXPECT_FALSE(output.targets.set[headYaw]) << "the head is not part of it";
  EXPECT_TRUE(output.finished);
}

TEST_F(StandMotionTest, anotherRobotStandsOtherwise) {
  robotIs(0);
  const JointArray first = output.targets.angles;
  robotIs(1);
  EXPECT_NE(output.targets.angles, first) << "type 1 has longer legs";
}

TEST_F(StandMotionTest, fadesInByItsParameterAndMovesNothingUntilTheRobotIsKnown) {
  harness.module().fadeSeconds = 0.3;
  harness.cycle();
  EXPECT_EQ(output.fadeSeconds, 0.3);
  EXPECT_FALSE(output.targets.set[lKneePitch]);
}

TEST(StandMotion, aWalkThatCannotBeIsAnErrorAtTheStart) {
  test::ScratchFolder folder;
  folder.write("walking.yaml", "posture: {hipHeight: 2}\n");
  test::ModuleHarness<StandMotion> harness({"config", folder.path()});
  EXPECT_EQ(thrownBy([&] { harness.module(); }),
            folder / "walking.yaml" + ":1: posture.hipHeight must be within [0.1, 0.4], not 2");
}

}  // namespace
}  // namespace plumbline
