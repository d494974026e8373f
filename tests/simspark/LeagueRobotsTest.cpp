#include "simspark/LeagueRobots.h"

#include <gtest/gtest.h>

#include <filesystem>

#include "framework/ConfigFolder.h"
#include "framework/ConfigurationError.h"
#include "robot/MechanismFile.h"

namespace plumbline {
namespace {

TEST(LeagueRobots, AreTheFilesOfTheConfiguration) {
  ASSERT_TRUE(
      std::filesystem::exists(configPath("robots/" + simsparkRobotName(numSimsparkTypes() - 1) + ".json")));
  ASSERT_FALSE(
      std::filesystem::exists(configPath("robots/" + simsparkRobotName(numSimsparkTypes()) + ".json")));
  for (int type = 0; type < numSimsparkTypes(); ++type) {
    EXPECT_EQ(simsparkRobot(type).name, simsparkRobotName(type));
    EXPECT_EQ(findMechanism(simsparkRobotName(type)).name, simsparkRobotName(type));
  }
}

TEST(LeagueRobots, AnotherTypeIsRefusedWithThoseThereAre) {
  const std::string next = std::to_string(numSimsparkTypes()), last = std::to_string(numSimsparkTypes() - 1);
  for (const int type : {numSimsparkTypes(), -1}) {
    try {
      simsparkRobot(type);
      FAIL() << type;
    } catch (const ConfigurationError& error) {
      EXPECT_EQ(error.what(), "there is no robot type " + std::to_string(type) +
                                  "; config/robots has the league's types 0 to " + last +
                                  ", the next one is a file simspark_type" + next + ".json there");
    }
  }
}

/// The league's files give what its server has to four digits and more; a walk repeats only with all.
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
