#include "simspark/LeagueRobots.h"

#include <gtest/gtest.h>

#include "framework/ConfigurationError.h"
#include "robot/MechanismFile.h"

namespace plumbline {
namespace {

TEST(LeagueRobots, AreTheFilesOfTheConfiguration) {
  ASSERT_EQ(numSimsparkTypes(), 5);
  for (int type = 0; type < 5; ++type) {
    EXPECT_EQ(simsparkRobot(type).name, simsparkRobotName(type));
    EXPECT_EQ(findMechanism(simsparkRobotName(type)).name, simsparkRobotName(type));
  }
}

TEST(LeagueRobots, AnotherTypeIsRefusedWithThoseThereAre) {
  for (const int type : {5, -1}) {
    try {
      simsparkRobot(type);
      FAIL() << type;
    } catch (const ConfigurationError& error) {
      EXPECT_EQ(error.what(), "there is no robot type " + std::to_string(type) +
                                  "; config/robots has the league's types 0 to 4, the next one is a file "
                                  "simspark_type5.json there");
    }
  }
}

/// What the league's server has is told by its files to four digits and more; a walk repeats only with all.
TEST(LeagueRobots, KeepEveryDigitOfTheirFiles) {
  const RobotModel& robot = simsparkRobot(3);
  EXPECT_EQ(robot.linkMovedBy(lHipYawPitch).axis, Vec3(0, 1, -1).normalized());
  EXPECT_EQ(robot.linkMovedBy(rHipYawPitch).axis, Vec3(0, 1, 1).normalized());
  EXPECT_EQ(robot.linkMovedBy(headYaw).lower, -120 * 3.14159265358979323846 / 180);
  EXPECT_EQ(robot.linkMovedBy(lAnklePitch).maxSpeed, 6.1395);
  EXPECT_EQ(robot.linkMovedBy(lKneePitch).shape.size, Vec3(0.07, 0.08, 0.11));
  EXPECT_TRUE(robot.linkMovedBy(lKneePitch).collides);
  EXPECT_FALSE(robot.linkMovedBy(lHipRoll).collides);
}

}  // namespace
}  // namespace plumbline
