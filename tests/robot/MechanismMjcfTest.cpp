#include <gtest/gtest.h>

#include <cmath>

#include "robot/MechanismFileFixture.h"

namespace plumbline {
namespace {

using MechanismMjcf = MechanismFileFixture;

/// Two hinges above each other, the second one off its body's frame, angles in degrees.
std::string arm(const std::string& from = "", const std::string& to = "") {
  std::string text = R"(<mujoco model="arm">
 <default>
  <joint armature="0.01" damping="0.1"/>
  <default class="strong"><position kp="30" kv="0.5" forcerange="-4 4"/></default>
 </default>
 <worldbody>
  <geom type="plane" size="1 1 1"/>
  <body name="upper" pos="0 0 1">
   <joint name="shoulder" axis="0 1 0" range="-90 45"/>
   <geom type="box" size="0.1 0.2 0.3" pos="0 0 -0.3" mass="1.2"/>
   <body name="lower" pos="0 0 -0.6" euler="0 90 0">
    <joint name="elbow" axis="0 0 1" pos="0.05 0 0" damping="0"/>
    <inertial pos="0.1 0 0" mass="0.5" diaginertia="0.001 0.002 0.003"/>
    <site name="imu" pos="0.02 0 0"/>
    <body name="hand" pos="0.2 0 0"><geom type="sphere" size="0.05" mass="0.1"/></body>
   </body>
  </body>
 </worldbody>
 <actuator>
  <position class="strong" joint="shoulder"/>
  <general joint="elbow" biastype="affine" gainprm="12" biasprm="0 -12 -0.2" forcerange="-2 1"/>
 </actuator>
 <sensor><gyro site="imu"/></sensor>
</mujoco>)";
  if (const std::size_t at = text.find(from); !from.empty() && at != std::string::npos)
    text.replace(at, from.size(), to);
  return text;
}

TEST_F(MechanismMjcf, bodiesJointsAndServos) {
  const Mechanism robot = readMechanism(write("arm.xml", arm()), [](const std::string&) {});
  EXPECT_EQ(robot.name, "arm");
  ASSERT_EQ(robot.joints.size(), 2U);
  const auto &shoulder = robot.joints[0], &elbow = robot.joints[1];
  EXPECT_EQ(shoulder.name, "shoulder");
  EXPECT_NEAR(shoulder.origin.z(), 1, 1e-12);
  EXPECT_NEAR(shoulder.lower, -M_PI / 2, 1e-12);
  EXPECT_NEAR(shoulder.upper, M_PI / 4, 1e-12);
  EXPECT_DOUBLE_EQ(shoulder.servo.kp, 30);
  EXPECT_DOUBLE_EQ(shoulder.servo.kd, 0.5);
  EXPECT_DOUBLE_EQ(shoulder.damping, 0.1) << "of the joint, not of its servo";
  EXPECT_DOUBLE_EQ(shoulder.servo.armature, 0.01);
  EXPECT_DOUBLE_EQ(shoulder.maxTorque, 4);
  EXPECT_DOUBLE_EQ(elbow.servo.kp, 12);
  EXPECT_DOUBLE_EQ(elbow.servo.kd, 0.2);
  EXPECT_DOUBLE_EQ(elbow.maxTorque, 2);
  EXPECT_DOUBLE_EQ(elbow.upper, Mechanism::maxTurns);
  // The joint sits 0.05 along the turned body's x, which points down.
  EXPECT_NEAR((elbow.origin - Vec3(0, 0, -0.65)).norm(), 0, 1e-12);
  EXPECT_TRUE(robot.hasImu);
  EXPECT_NEAR((robot.imu.gyro - Vec3(-0.03, 0, 0)).norm(), 0, 1e-12);
}

TEST_F(MechanismMjcf, massesOfGeomsAndOfWhatIsFixed) {
  const Mechanism robot = readMechanism(write("arm.xml", arm()), [](const std::string&) {});
  const auto& upper = robot.links[1];
  EXPECT_DOUBLE_EQ(upper.mass, 1.2);
  EXPECT_NEAR(upper.com.z(), -0.3, 1e-12);
  EXPECT_NEAR(upper.inertia(0, 0), 1.2 / 3 * (0.04 + 0.09), 1e-12);
  EXPECT_NEAR(upper.inertia(2, 2), 1.2 / 3 * (0.01 + 0.04), 1e-12);
  // The hand is fixed to the lower link, whose frame is at its joint.
  const auto& lower = robot.links[2];
  EXPECT_DOUBLE_EQ(lower.mass, 0.6);
  EXPECT_NEAR(lower.com.x(), (0.5 * 0.05 + 0.1 * 0.15) / 0.6, 1e-12);
  const double apart = 0.1, reduced = 0.5 * 0.1 / 0.6;
  EXPECT_NEAR(lower.inertia(1, 1), 0.002 + 0.4 * 0.1 * 0.0025 + reduced * apart * apart, 1e-12);
}

TEST_F(MechanismMjcf, solidsByTheirDensity) {
  const auto massOf = [&](const std::string& geom) {
    const std::string text = arm(R"(<geom type="box" size="0.1 0.2 0.3" pos="0 0 -0.3" mass="1.2"/>)", geom);
    return readMechanism(write("solid.xml", text), [](const std::string&) {}).links[1].mass;
  };
  EXPECT_NEAR(massOf(R"(<geom type="sphere" size="0.1" density="500"/>)"), 500 * 4.0 / 3 * M_PI * 1e-3, 1e-9);
  EXPECT_NEAR(massOf(R"(<geom type="cylinder" size="0.1 0.2"/>)"), 1000 * M_PI * 0.01 * 0.4, 1e-9);
  EXPECT_NEAR(massOf(R"(<geom type="capsule" size="0.1" fromto="0 0 0 0.4 0 0"/>)"),
              1000 * (M_PI * 0.01 * 0.4 + 4.0 / 3 * M_PI * 1e-3), 1e-9);
  EXPECT_NEAR(massOf(R"(<geom type="ellipsoid" size="0.1 0.2 0.3"/>)"), 1000 * 4.0 / 3 * M_PI * 6e-3, 1e-9);
}

TEST_F(MechanismMjcf, aFreeBaseAndAJointThatFollowsAnother) {
  const std::string text = R"(<mujoco model="walker"><compiler angle="radian"/><worldbody>
<body name="torso"><freejoint/><inertial pos="0 0 0" mass="2" diaginertia="0.01 0.01 0.01"/>
 <body name="a" pos="0 0.1 0"><joint name="left" axis="0 1 0" range="-1 1"/>
  <inertial pos="0 0 -0.1" mass="0.2" diaginertia="1e-3 1e-3 1e-3"/></body>
 <body name="b" pos="0 -0.1 0"><joint name="right" axis="0 1 0" range="-1 1"/>
  <inertial pos="0 0 -0.1" mass="0.2" diaginertia="1e-3 1e-3 1e-3"/></body></body></worldbody>
<equality><joint joint1="right" joint2="left" polycoef="0.1 -1 0 0 0"/></equality>
<actuator><position joint="left" kp="5" forcerange="-1 1"/></actuator></mujoco>)";
  const Mechanism robot = readMechanism(write("w.xml", text), [](const std::string&) {});
  EXPECT_EQ(robot.links[0].name, "torso");
  EXPECT_EQ(robot.joints[1].driver, 0);
  EXPECT_DOUBLE_EQ(robot.joints[1].driverRatio, -1);
  EXPECT_DOUBLE_EQ(robot.joints[1].driverOffset, 0.1);
  EXPECT_DOUBLE_EQ(robot.joints[0].upper, 1);
  EXPECT_DOUBLE_EQ(robot.joints[1].servo.kp, 5);
}

TEST_F(MechanismMjcf, aServoTableInTheSameFolderCounts) {
  write("arm.servo.json", R"({"joints": {"elbow": {"kp": 7, "kd": 0.3, "armature": 0.02, "max_speed": 9}}})");
  const Mechanism robot = readMechanism(write("arm.xml", arm()), [](const std::string&) {});
  EXPECT_DOUBLE_EQ(robot.joints[1].servo.kp, 7);
  EXPECT_DOUBLE_EQ(robot.joints[1].maxSpeed, 9);
  EXPECT_DOUBLE_EQ(robot.joints[0].servo.kp, 30);
}

TEST_F(MechanismMjcf, theOutermostClassHoldsWhateverItsName) {
  const Mechanism robot =
      readMechanism(write("arm.xml", arm("<default>", "<default class=\"arm\">")), [](const std::string&) {});
  EXPECT_DOUBLE_EQ(robot.joints[0].servo.armature, 0.01);
  EXPECT_DOUBLE_EQ(robot.joints[0].damping, 0.1);
}

TEST_F(MechanismMjcf, frictionlossIsTheJointsFriction) {
  const Mechanism robot =
      readMechanism(write("arm.xml", arm("name=\"shoulder\"", "name=\"shoulder\" frictionloss=\"0.2\"")), {});
  EXPECT_DOUBLE_EQ(robot.joints[0].friction, 0.2);
  EXPECT_DOUBLE_EQ(robot.joints[1].friction, 0);
  EXPECT_EQ(errorOf("a.xml", arm("name=\"shoulder\"", "name=\"shoulder\" frictionloss=\"-1\"")),
            "a.xml:9: frictionloss is -1; give it 0 or more");
}

TEST_F(MechanismMjcf, whatWouldBeMissingOrShiftedIsRefused) {
  EXPECT_EQ(errorOf("a.xml",
                    arm("<body name=\"hand\"", "<frame><body name=\"finger\"/></frame><body name=\"hand\"")),
            "a.xml:15: <frame> is not followed; save the whole model with MuJoCo (mj_saveLastXML)");
  EXPECT_EQ(
      errorOf("a.xml", arm("<body name=\"upper\"", "<attach model=\"m\" prefix=\"\"/><body name=\"upper\"")),
      "a.xml:8: <attach> is not followed; save the whole model with MuJoCo (mj_saveLastXML)");
  EXPECT_EQ(errorOf("a.xml", arm("name=\"shoulder\"", "name=\"shoulder\" ref=\"10\"")),
            "a.xml:9: joint shoulder: ref is not 0; save the model with its zero where the body is drawn");
  EXPECT_EQ(
      errorOf("a.xml", arm("name=\"shoulder\"", "name=\"shoulder\" stiffness=\"2\"")),
      "a.xml:9: joint shoulder: stiffness is a spring, which the nominal model does not have; take it out");
  EXPECT_EQ(
      errorOf("a.xml", arm("name=\"upper\"", "name=\"upper\" gravcomp=\"1\"")),
      "a.xml:8: body upper: gravcomp takes gravity off it, which the nominal model does not; take it out");
  EXPECT_EQ(errorOf("a.xml", arm("</worldbody>", "<body name=\"ball\"/></worldbody>")),
            "a.xml:18: a second body in the world; a robot is one tree: give the file of the robot alone");
}

TEST_F(MechanismMjcf, mistakesAreNamedWithTheirLine) {
  EXPECT_EQ(errorOf("a.xml", "<robot/>"), "a.xml: no <mujoco>; give a model of MuJoCo");
  EXPECT_EQ(errorOf("a.xml", arm("name=\"shoulder\"", "name=\"shoulder\" type=\"ball\"")),
            "a.xml:9: type is \"ball\"; what can be used is hinge, slide and a free base");
  EXPECT_EQ(errorOf("a.xml", arm("<joint name=\"elbow\"",
                                 "<joint name=\"wrist\" axis=\"1 0 0\"/><joint name=\"elbow\"")),
            "a.xml:12: body lower has two joints; put a body between them");
  EXPECT_EQ(
      errorOf("a.xml", arm("type=\"box\" size=\"0.1 0.2 0.3\"", "type=\"mesh\" mesh=\"m\"")),
      "a.xml:10: a body's mass is that of a mesh; give the body an <inertial> (mj_saveLastXML writes them)");
  EXPECT_EQ(errorOf("a.xml", arm("class=\"strong\" joint", "class=\"string\" joint")),
            "a.xml:20: there is no class string");
  EXPECT_EQ(errorOf("a.xml", arm("<position class=\"strong\" joint=\"shoulder\"/>", "")),
            "a.xml: joint shoulder has no actuator; give it one, or a servo table next to the file: "
            "a.servo.json");
}

}  // namespace
}  // namespace plumbline
