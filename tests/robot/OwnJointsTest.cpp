#include "robot/OwnJoints.h"

#include <gtest/gtest.h>

#include "robot/HumanoidModel.h"
#include "robot/MechanismFile.h"

namespace plumbline {
namespace {

/// A base with one joint per name, all about the axis.
Mechanism robotWith(const std::vector<std::string>& names, const Vec3& axis = Vec3::UnitY()) {
  Mechanism robot;
  robot.name = "test";
  robot.links.resize(names.size() + 1);
  for (std::size_t i = 0; i < names.size(); ++i) {
    Mechanism::Joint joint;
    joint.name = names[i];
    joint.child = static_cast<int>(i + 1);
    joint.axis = axis;
    robot.joints.push_back(joint);
    robot.links[i + 1].parent = 0;
  }
  return robot;
}

std::string errorOf(const Mechanism& robot) {
  try {
    jointNumbers(robot);
  } catch (const std::invalid_argument& error) {
    return error.what();
  }
  return "";
}

TEST(OwnJoints, aHumanoidsJointsHaveTheirNumberByName) {
  EXPECT_EQ(jointNumbers(robotWith({"RKneePitch", "HeadYaw"})), (std::vector{rKneePitch, headYaw}));
}

TEST(OwnJoints, theRangeSaysHowAJointIsMirrored) {
  const auto number = [](int n) { return static_cast<JointId>(n); };
  EXPECT_EQ(jointNumbers(robotWith({"Spine", "Neck"})), (std::vector{number(24), number(25)}));
  EXPECT_EQ(jointNumbers(robotWith({"Waist"}, Vec3::UnitZ())), std::vector{number(36)});
  EXPECT_EQ(jointNumbers(robotWith({"RWrist", "LWrist", "LFinger"})),
            (std::vector{number(49), number(44), number(24)}));
  EXPECT_EQ(jointNumbers(robotWith({"left_wrist", "right_wrist"}, Vec3::UnitX())),
            (std::vector{number(54), number(59)}));
}

TEST(OwnJoints, signOfAPairFollowsFromItsAxes) {
  Mechanism robot = robotWith({"LWrist", "RWrist"}, Vec3(0, 1, -1).normalized());
  robot.joints[1].axis = Vec3(0, 1, 1).normalized();
  EXPECT_EQ(jointNumbers(robot)[0], 44) << "mirror images";
  robot.joints[1].axis *= -1;
  EXPECT_EQ(jointNumbers(robot)[0], 54) << "mirror images the other way round";
  robot.joints[1].axis = Vec3::UnitX();
  EXPECT_EQ(
      errorOf(robot),
      "robot test, joint RWrist: its axis is not the mirror image of that of LWrist; turn it, or let the "
      "names differ in more than the side");
}

TEST(OwnJoints, whatSlidesOrFollowsAnotherMotorIsNoJointOfTheModel) {
  Mechanism robot = robotWith({"Finger", "Thumb", "Waist"});
  robot.joints[0].type = Mechanism::Joint::Type::prismatic;
  robot.joints[1].driver = 2;
  EXPECT_EQ(jointNumbers(robot), (std::vector{noJoint, noJoint, static_cast<JointId>(24)}));
}

TEST(OwnJoints, moreThanThereIsRoomForIsAnError) {
  std::vector<std::string> names;
  for (int i = 0; i < 13; ++i) names.push_back("Spine" + std::to_string(i));
  EXPECT_EQ(
      errorOf(robotWith(names)),
      "robot test, joint Spine12: a robot has at most 12 single joints of its own that keep their sign when "
      "left and right change places");
  names.clear();
  for (int i = 0; i < 6; ++i)
    for (const char* side : {"L", "R"}) names.push_back(side + std::to_string(i));
  EXPECT_EQ(
      errorOf(robotWith(names, Vec3::UnitX())),
      "robot test, joint L5: a robot has at most 5 pairs of joints of its own that change their sign when "
      "left and right change places");
}

TEST(OwnJoints, namesOfASide) {
  const std::vector<std::pair<const char*, const char*>> sides = {{"LWrist", "RWrist"},
                                                                  {"arm_l", "arm_r"},
                                                                  {"FL_hip", "FR_hip"},
                                                                  {"RL_hip", "RR_hip"},
                                                                  {"LeftElbow", "RightElbow"}};
  for (const auto& [left, right] : sides) {
    EXPECT_TRUE(isLeftOf(left, right)) << left;
    EXPECT_FALSE(isLeftOf(right, left)) << left;
  }
  EXPECT_FALSE(isLeftOf("FL_hip", "RL_hip"));
  EXPECT_FALSE(isLeftOf("Waist", "Waist"));
  EXPECT_FALSE(isLeftOf("LWristYaw", "RWristPitch"));
}

TEST(OwnJoints, ofTheRobotsForTests) {
  const RobotModel upright = Humanoid(readMechanism("tests/data/robots/waist_and_arms.json")).model();
  EXPECT_EQ(upright.numJoints(), 29);
  EXPECT_EQ(upright.requireJoint("WaistYaw"), 36);
  EXPECT_EQ(upright.requireJoint("LWristPitch"), 44);
  EXPECT_EQ(upright.requireJoint("RWristRoll"), 60);
  const RobotModel quadruped = Humanoid(readMechanism("tests/data/robots/quadruped.json")).model();
  EXPECT_EQ(quadruped.numJoints(), 12);
  EXPECT_EQ(quadruped.requireJoint("RR_knee"), 52);
  EXPECT_EQ(quadruped.requireJoint("FR_hip_roll"), 59);
  EXPECT_EQ(quadruped.linkMovedBy(quadruped.requireJoint("FR_knee")).upper, -0.2);
}

}  // namespace
}  // namespace plumbline
