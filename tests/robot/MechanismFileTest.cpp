#include "robot/MechanismFile.h"

#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <nlohmann/json.hpp>

#include "robot/Mechanism.h"
#include "robot/MechanismFileFixture.h"

namespace plumbline {
namespace {

using MechanismFile = MechanismFileFixture;

TEST_F(MechanismFile, naoIsReadWithAllItHas) {
  const Mechanism nao = findMechanism("nao_v5");
  EXPECT_EQ(nao.numJoints(), 24);
  ASSERT_EQ(nao.links.size(), 25u);
  EXPECT_EQ(nao.links[0].name, "torso");
  EXPECT_NEAR(nao.totalMass(), 5.30535, 1e-9);
  for (int j = 0; j < nao.numJoints(); ++j) {
    const Mechanism::Joint& joint = nao.joints[static_cast<std::size_t>(j)];
    EXPECT_EQ(joint.child, j + 1);
    EXPECT_LT(joint.parent, joint.child);
    EXPECT_EQ(nao.links[static_cast<std::size_t>(joint.child)].parent, joint.parent);
    EXPECT_NEAR(joint.axis.norm(), 1, 1e-15);
  }
  const Mechanism::Joint& knee = nao.joints[static_cast<std::size_t>(nao.jointIndex("LKneePitch"))];
  EXPECT_EQ(knee.servo.kp, 37.788);
  EXPECT_EQ(knee.servo.kd, 0.7558);
  EXPECT_EQ(knee.servo.armature, 0.006);
  EXPECT_EQ(knee.maxTorque, 3.023);
  EXPECT_EQ(knee.encoder, Mechanism::Joint::Encoder::motor);
  const Mechanism::Joint& hip = nao.joints[static_cast<std::size_t>(nao.jointIndex("RHipYawPitch"))];
  EXPECT_EQ(hip.driver, nao.jointIndex("LHipYawPitch"));
  EXPECT_EQ(hip.driverRatio, 1);
  ASSERT_EQ(nao.feet.size(), 2u);
  EXPECT_EQ(nao.feet[1].name, "RFoot");
  EXPECT_EQ(nao.feet[1].link, nao.linkIndex("r_ankle"));
  EXPECT_EQ(nao.feet[1].sensors.size(), 4u);
  EXPECT_NEAR(nao.feet[1].soleCentre.z() - nao.feet[1].soleSize.z() / 2, -0.0452, 1e-12);
  EXPECT_TRUE(nao.hasImu);
  EXPECT_EQ(nao.imu.gyro, Vec3(-0.008, 0.006, 0.029));
  EXPECT_EQ(nao.controlHz, 100);
}

TEST_F(MechanismFile, naoStandsOnItsLegs) {
  const Mechanism nao = findMechanism("nao_v5");
  std::vector<double> q(24, 0.0);
  const auto at = [&](const char* joint) -> double& {
    return q[static_cast<std::size_t>(nao.jointIndex(joint))];
  };
  const auto ankle = static_cast<std::size_t>(nao.linkIndex("l_ankle"));
  EXPECT_TRUE(linkPoses(nao, q)[ankle].translation().isApprox(Vec3(0, 0.05, -0.085 - 0.1 - 0.1029), 1e-12));
  at("LHipPitch") = -0.45, at("LKneePitch") = 0.85, at("LAnklePitch") = -0.4;
  const Pose3 bent = linkPoses(nao, q)[ankle];
  EXPECT_TRUE(bent.linear().isIdentity(1e-12));
  EXPECT_NEAR(bent.translation().z(), -0.085 - 0.1 * std::cos(0.45) - 0.1029 * std::cos(0.4), 1e-12);
  EXPECT_NEAR(bent.translation().x(), 0.1 * std::sin(0.45) - 0.1029 * std::sin(0.4), 1e-12);
  EXPECT_EQ(nao.chain(static_cast<int>(ankle)).size(), 6u);
  EXPECT_EQ(nao.joints[static_cast<std::size_t>(nao.chain(static_cast<int>(ankle))[0])].name, "LHipYawPitch");
}

TEST_F(MechanismFile, theArmsAreReadWithTheirMotors) {
  const Mechanism arm = findMechanism("so101");
  EXPECT_EQ(arm.numJoints(), 6);
  EXPECT_EQ(arm.joints[1].servo.model, Servo::Model::position);
  EXPECT_EQ(arm.joints[1].servo.kt, 1.444);
  EXPECT_EQ(arm.controlHz, 50);
  EXPECT_FALSE(arm.hasImu);
  // q = 0: upper arm up, forearm and gripper forward.
  const std::vector<Pose3> poses = linkPoses(arm, std::vector<double>(6, 0.0));
  const Vec3 elbow = poses[3].translation(), shoulder = poses[2].translation(),
             wrist = poses[4].translation();
  EXPECT_NEAR(elbow.z() - shoulder.z(), 0.11257, 1e-8);
  EXPECT_NEAR(wrist.x() - elbow.x(), 0.1349, 1e-8);
  EXPECT_NEAR(wrist.z() - elbow.z(), 0.0052, 1e-8);

  const Mechanism pendulum = findMechanism("xl330_pendulum");
  EXPECT_EQ(pendulum.joints[0].servo.model, Servo::Model::dcMotor);
  EXPECT_EQ(pendulum.joints[0].servo.maxPwm, 1);
  EXPECT_EQ(pendulum.gravity.z(), -9.80665);
  EXPECT_NEAR(centreOfMass(pendulum, linkPoses(pendulum, {M_PI / 2})).x(), -0.49 * 0.1 / 1.49, 1e-12);
}

TEST_F(MechanismFile, parentsComeFirstWhateverTheFilesOrder) {
  const Mechanism robot = readMechanism(write("r.json", R"({"name": "r", "links": {
 "c": {"mass": 3, "com": [0,0,0], "inertia": [1,1,1,0,0,0]}, "b": {"mass": 2, "com": [0,0,0], "inertia": [1,1,1,0,0,0]},
 "a": {"mass": 1, "com": [0,0,0], "inertia": [1,1,1,0,0,0]}}, "joints": [
 {"name": "j2", "type": "prismatic", "parent": "b", "child": "c", "origin": [0,0,0], "axis": [0,0,1], "lower": -1, "upper": 1,
  "max_torque": 1, "max_speed": 1, "encoder": "link", "servo": {"kp": 1, "kd": 0, "armature": 0}},
 {"name": "j1", "parent": "a", "child": "b", "origin": [1,0,0], "rpy": [0,0,1.5707963267948966], "axis": [1,0,0], "lower": -1, "upper": 1,
  "max_torque": 1, "max_speed": 1, "servo": {"kp": 1, "kd": 0, "armature": 0}}]})"));
  EXPECT_EQ(robot.joints[0].name, "j1");
  EXPECT_EQ(robot.joints[1].name, "j2");
  EXPECT_EQ(robot.links[2].mass, 3);
  EXPECT_EQ(robot.joints[1].type, Mechanism::Joint::Type::prismatic);
  EXPECT_EQ(robot.joints[1].encoder, Mechanism::Joint::Encoder::link);
  const Vec3 end = linkPoses(robot, {M_PI / 2, 0.5})[2].translation();
  // x of b points along y of a; turned by 90 degrees about it, z of b points along x of a... times 0.5.
  EXPECT_TRUE(end.isApprox(Vec3(1.5, 0, 0), 1e-12)) << end.transpose();
}

TEST_F(MechanismFile, anOlderFilesNoteAndSensorsStandInForDriverAndFeet) {
  std::ifstream stream("config/robots/nao_v5.json");
  nlohmann::json file = nlohmann::json::parse(stream);
  ASSERT_EQ(file.erase("feet"), 1u);
  std::size_t driven = 0;
  for (nlohmann::json& joint : file["joints"]) driven += joint.erase("driven_by");
  ASSERT_EQ(driven, 1u);
  const Mechanism nao = readMechanism(write("old.json", file.dump()));
  EXPECT_EQ(nao.joints[static_cast<std::size_t>(nao.jointIndex("RHipYawPitch"))].driver,
            nao.jointIndex("LHipYawPitch"));
  ASSERT_EQ(nao.feet.size(), 2u);
  EXPECT_EQ(nao.feet[0].link, nao.linkIndex("l_ankle"));
  EXPECT_NEAR(nao.feet[0].soleSize.x(), 0.1005, 1e-12);
  EXPECT_NEAR(nao.feet[0].soleCentre.z() - nao.feet[0].soleSize.z() / 2, -0.04511, 1e-12);
}

TEST_F(MechanismFile, robotsAreFoundByName) {
  try {
    findMechanism("nao_v9");
    FAIL();
  } catch (const MechanismError& error) {
    EXPECT_STREQ(
        error.what(),
        "config/robots: no robot nao_v9; there are nao_v5, simspark_type0, simspark_type1, simspark_type2, "
        "simspark_type3, simspark_type4, so101, xl330_pendulum; give the robot's file");
  }
  EXPECT_THROW(findMechanism("../robots/nao_v5"), MechanismError);
}

}  // namespace
}  // namespace plumbline
