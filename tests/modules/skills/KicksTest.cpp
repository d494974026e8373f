#include "modules/skills/Kicks.h"

#include <gtest/gtest.h>

#include <memory>

#include "math/Angle.h"
#include "simspark/LeagueRobots.h"
#include "support/ModuleHarness.h"
#include "support/ScratchFolder.h"
#include "support/Thrown.h"

namespace plumbline {
namespace {

class KicksFileTest : public testing::Test {
protected:
  KicksFileTest() { robot.model = simsparkRobot(0); }
  void write(const std::string& name, const std::string& ball, const std::string& kick) const {
    folder.write("motions/" + name + ".yaml",
                 "ball: " + ball + "\n" + kick + "keyframes:\n  - {time: 0.1, RHipPitch: -20}\n");
  }
  test::ScratchFolder folder;
  test::ModuleHarness<Kicks> harness{{folder.path()}};
  RobotDescription& robot = harness.input<RobotDescription>();
  const SkillKickParameters& kicks = harness.output<SkillKickParameters>();
};

TEST_F(KicksFileTest, areTheMotionsThatSayKickTheShortestFirst) {
  write("far", "[0.2, -0.05]", "kick: {distance: 9, direction: 90}\n");
  write("near", "[0.15, -0.06]", "kick: {distance: 3}\n");
  write("bow", "[0.15, -0.06]", "");
  robot.name = "a robot";
  harness.cycle();
  ASSERT_EQ(kicks.kicks.size(), 2u);
  EXPECT_EQ(kicks.kicks[0].motion, "near");
  EXPECT_EQ(kicks.kicks[0].ballPosition, Vec2(0.15, -0.06));
  EXPECT_EQ(kicks.kicks[1].motion, "far");
  EXPECT_NEAR(kicks.kicks[1].direction, pi / 2, 1e-9);
  EXPECT_EQ(kicks.reach(), 9);
}

TEST_F(KicksFileTest, aKickWithTheLeftFootIsGivenForTheRight) {
  write("left", "[0.2, 0.05]", "kick: {distance: 4, direction: 90}\n");
  robot.name = "a robot";
  harness.cycle();
  EXPECT_EQ(kicks.kicks[0].ballPosition, Vec2(0.2, -0.05));
  EXPECT_NEAR(kicks.kicks[0].direction, -pi / 2, 1e-9);
}

TEST_F(KicksFileTest, areReadOnceForEachRobot) {
  write("near", "[0.2, -0.05]", "kick: {distance: 3}\n");
  robot.name = "a robot";
  harness.cycle();
  write("far", "[0.2, -0.05]", "kick: {distance: 9}\n");
  harness.cycle();
  EXPECT_EQ(kicks.kicks.size(), 1u);
  robot.name = "another robot";
  harness.cycle();
  EXPECT_EQ(kicks.kicks.size(), 2u);
}

TEST_F(KicksFileTest, aRobotWithoutAKickIsAnErrorAndOneThatMainKnowsAtTheStart) {
  write("bow", "[0.15, -0.06]", "");
  const std::string error = "no motion in motions/ of robot " + robot.model.name +
                            " is a kick: give one the key kick (doc/how-to/add-a-motion.md)";
  robot.name = robot.model.name;
  EXPECT_EQ(thrownBy([&] { harness.cycle(); }), error);
  test::ModuleHarness<Kicks> started({folder.path()});
  started.objects().set(std::make_shared<RobotModel>(robot.model));
  EXPECT_EQ(thrownBy([&] { started.module(); }), error);
}

}  // namespace
}  // namespace plumbline
