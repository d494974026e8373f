#include <gtest/gtest.h>

#include <cstdio>
#include <filesystem>

#include "robot/Mechanism.h"
#include "robot/MechanismFileFixture.h"

namespace plumbline {
namespace {

using MechanismUrdf = MechanismFileFixture;

std::string vectorText(const Vec3& v) {
  char text[96];
  std::snprintf(text, sizeof text, "%.17g %.17g %.17g", v.x(), v.y(), v.z());
  return text;
}

std::string exact(double x) {
  char text[32];
  std::snprintf(text, sizeof text, "%.17g", x);
  return text;
}

/// The URDF a user would write of a mechanism, its joints in reverse order.
std::string urdfOf(const Mechanism& m) {
  std::string urdf = "<?xml version=\"1.0\"?>\n<robot name=\"" + m.name + "\">\n";
  for (const Mechanism::Link& link : m.links) {
    const Mat3& i = link.inertia;
    urdf += "<link name=\"" + link.name + "\"><inertial><origin xyz=\"" + vectorText(link.com) +
            "\" rpy=\"0 0 0\"/><mass value=\"" + exact(link.mass) + "\"/><inertia ixx=\"" + exact(i(0, 0)) +
            "\" iyy=\"" + exact(i(1, 1)) + "\" izz=\"" + exact(i(2, 2)) + "\" ixy=\"" + exact(i(0, 1)) +
            "\" ixz=\"" + exact(i(0, 2)) + "\" iyz=\"" + exact(i(1, 2)) + "\"/></inertial></link>\n";
  }
  for (int j = m.numJoints() - 1; j >= 0; --j) {
    const Mechanism::Joint& joint = m.joints[static_cast<std::size_t>(j)];
    urdf += "<joint name=\"" + joint.name + "\" type=\"revolute\"><origin xyz=\"" + vectorText(joint.origin) +
            "\" rpy=\"" + vectorText(joint.rpy) + "\"/><parent link=\"" +
            m.links[static_cast<std::size_t>(joint.parent)].name + "\"/><child link=\"" +
            m.links[static_cast<std::size_t>(joint.child)].name + "\"/><axis xyz=\"" +
            vectorText(joint.axis) + "\"/><limit lower=\"" + exact(joint.lower) + "\" upper=\"" +
            exact(joint.upper) + "\" effort=\"" + exact(joint.maxTorque) + "\" velocity=\"" +
            exact(joint.maxSpeed) + "\"/>";
    if (joint.driver >= 0)
      urdf += "<mimic joint=\"" + m.joints[static_cast<std::size_t>(joint.driver)].name + "\"/>";
    urdf += "</joint>\n";
  }
  return urdf + "</robot>\n";
}

/// Its servo table as YAML, with the sensors.
std::string tableOf(const Mechanism& m) {
  std::string table = "joints:\n";
  for (const Mechanism::Joint& joint : m.joints) {
    const Servo& s = joint.servo;
    table += "  " + joint.name + ": {kp: " + exact(s.kp) + ", kd: " + exact(s.kd) +
             ", armature: " + exact(s.armature);
    if (s.model == Servo::Model::dcMotor) table += ", model: dc_motor";
    if (s.R > 0)
      table += ", dc_motor: {kt: " + exact(s.kt) + ", R: " + exact(s.R) + ", vin: " + exact(s.vin) +
               ", error_gain: " + exact(s.errorGain) + ", kp_firmware: " + exact(s.kpFirmware) +
               ", max_pwm: " + exact(s.maxPwm) + "}";
    table += "}\n";
  }
  const auto list = [](const Vec3& v) {
    return "[" + exact(v.x()) + ", " + exact(v.y()) + ", " + exact(v.z()) + "]";
  };
  table += "gravity: " + list(m.gravity) + "\nrates: {control_hz: " + exact(m.controlHz) + "}\n";
  if (m.hasImu)
    table += "imu: {link: torso, gyro: " + list(m.imu.gyro) +
             ", accelerometer: " + list(m.imu.accelerometer) + "}\n";
  if (m.feet.empty()) return table;
  table += "feet:\n";
  for (const Mechanism::Foot& foot : m.feet)
    table += "  - {name: " + foot.name + ", link: " + m.links[static_cast<std::size_t>(foot.link)].name +
             ", sole_centre: " + list(foot.soleCentre) + ", sole_size: " + list(foot.soleSize) + "}\n";
  table += "fsr:\n";
  for (const Mechanism::Foot& foot : m.feet)
    for (const Mechanism::ForceSensor& sensor : foot.sensors)
      table += "  " + foot.name + "." + sensor.corner + ": " + list(sensor.position) + "\n";
  return table;
}

TEST_F(MechanismUrdf, dynamicsAreDoubtedOnceAndTheTablesFrictionCounts) {
  write("r.servo.yaml", "joints: {a: {kp: 1, kd: 0.1, armature: 0, friction: 0.2, damping: 0.3}}");
  const std::string text = R"(<robot name="r"><link name="base"/>
<link name="arm"><inertial><mass value="1"/><inertia ixx="1" iyy="1" izz="1" ixy="0" ixz="0" iyz="0"/></inertial></link>
<joint name="a" type="revolute"><parent link="base"/><child link="arm"/>
<limit lower="-1" upper="1" effort="2" velocity="3"/>
<dynamics friction="0.1"/></joint></robot>)";
  std::string warnings;
  const Mechanism robot =
      readMechanism(write("r.urdf", text), [&](const std::string& line) { warnings += line; });
  EXPECT_NE(
      warnings.find("r.urdf:5: <dynamics> is not read; if it is measured, give friction and damping in the "
                    "servo table"),
      std::string::npos)
      << warnings;
  EXPECT_DOUBLE_EQ(robot.joints[0].friction, 0.2);
  EXPECT_DOUBLE_EQ(robot.joints[0].damping, 0.3);
}

TEST_F(MechanismUrdf, aUrdfWithItsTableIsTheSameRobot) {
  for (const char* name : {"nao_v5", "so101", "xl330_pendulum"}) {
    SCOPED_TRACE(name);
    const Mechanism json = findMechanism(name);
    write("r.servo.yaml", tableOf(json));
    const Mechanism urdf = readMechanism(write("r.urdf", urdfOf(json)));
    EXPECT_EQ(urdf.name, json.name);
    EXPECT_EQ(urdf.gravity, json.gravity);
    EXPECT_EQ(urdf.controlHz, json.controlHz);
    EXPECT_EQ(urdf.hasImu, json.hasImu);
    EXPECT_EQ(urdf.imu.accelerometer, json.imu.accelerometer);
    ASSERT_EQ(urdf.joints.size(), json.joints.size());
    ASSERT_EQ(urdf.links[0].name, json.links[0].name);
    for (const Mechanism::Joint& a : json.joints) {  // the order may differ, the tree may not
      SCOPED_TRACE(a.name);
      ASSERT_GE(urdf.jointIndex(a.name), 0);
      const Mechanism::Joint& b = urdf.joints[static_cast<std::size_t>(urdf.jointIndex(a.name))];
      const Mechanism::Link& linkA = json.links[static_cast<std::size_t>(a.child)];
      const Mechanism::Link& linkB = urdf.links[static_cast<std::size_t>(b.child)];
      EXPECT_EQ(linkA.name, linkB.name);
      EXPECT_EQ(json.links[static_cast<std::size_t>(a.parent)].name,
                urdf.links[static_cast<std::size_t>(b.parent)].name);
      EXPECT_EQ(linkA.mass, linkB.mass);
      EXPECT_EQ(linkA.com, linkB.com);
      EXPECT_EQ(linkA.inertia, linkB.inertia);
      EXPECT_EQ(a.origin, b.origin);
      EXPECT_EQ(a.rpy, b.rpy);
      EXPECT_TRUE(a.axis.isApprox(b.axis, 1e-15));
      EXPECT_EQ(a.lower, b.lower);
      EXPECT_EQ(a.upper, b.upper);
      EXPECT_EQ(a.maxTorque, b.maxTorque);
      EXPECT_EQ(a.maxSpeed, b.maxSpeed);
      EXPECT_EQ(a.servo.model, b.servo.model);
      EXPECT_EQ(a.servo.kp, b.servo.kp);
      EXPECT_EQ(a.servo.kd, b.servo.kd);
      EXPECT_EQ(a.servo.armature, b.servo.armature);
      EXPECT_EQ(a.servo.kt, b.servo.kt);
      EXPECT_EQ(a.servo.errorGain, b.servo.errorGain);
      EXPECT_EQ(a.driver < 0, b.driver < 0);
      if (a.driver >= 0) {
        EXPECT_EQ(json.joints[static_cast<std::size_t>(a.driver)].name,
                  urdf.joints[static_cast<std::size_t>(b.driver)].name);
      }
    }
    ASSERT_EQ(urdf.feet.size(), json.feet.size());
    for (std::size_t f = 0; f < json.feet.size(); ++f) {
      EXPECT_EQ(urdf.feet[f].soleCentre, json.feet[f].soleCentre);
      EXPECT_EQ(urdf.feet[f].sensors.size(), 4u);
      EXPECT_EQ(urdf.links[static_cast<std::size_t>(urdf.feet[f].link)].name,
                json.links[static_cast<std::size_t>(json.feet[f].link)].name);
    }
  }
}

constexpr const char* mast = R"(<robot name="mast">
<link name="world"/>
<link name="plate"><inertial><mass value="2"/><inertia ixx="1" iyy="1" izz="1" ixy="0" ixz="0" iyz="0"/></inertial></link>
<link name="arm"><inertial><origin xyz="0 0 1" rpy="0 0 1.5707963267948966"/><mass value="1"/><inertia ixx="1" iyy="2" izz="1.5" ixy="0" ixz="0" iyz="0"/></inertial></link>
<link name="tool"><inertial><mass value="1"/><inertia ixx="0" iyy="0" izz="0" ixy="0" ixz="0" iyz="0"/></inertial></link>
<joint name="bolt" type="fixed"><origin xyz="0 0 1"/><parent link="world"/><child link="plate"/></joint>
<joint name="turn" type="continuous"><origin xyz="1 0 0"/><parent link="plate"/><child link="arm"/><axis xyz="0 0 2"/></joint>
<joint name="grip" type="fixed"><origin xyz="0 2 1"/><parent link="arm"/><child link="tool"/></joint>
</robot>
)";
constexpr const char* mastTable =
    R"({"joints": {"turn": {"kp": 1, "kd": 0, "armature": 0, "max_torque": 5, "max_speed": 2}}, "imu": {"link": "tool"}})";

TEST_F(MechanismUrdf, whatIsFixedInAUrdfBecomesOneLink) {
  write("mast.servo.json", mastTable);
  const Mechanism robot = readMechanism(write("mast.urdf", mast));
  ASSERT_EQ(robot.links.size(), 2u);
  EXPECT_EQ(robot.links[0].name, "world");
  EXPECT_EQ(robot.links[0].mass, 2);
  EXPECT_EQ(robot.links[0].com, Vec3(0, 0, 1));
  EXPECT_EQ(robot.joints[0].origin, Vec3(1, 0, 1));
  EXPECT_EQ(robot.joints[0].axis, Vec3(0, 0, 1));
  EXPECT_EQ(robot.joints[0].upper, Mechanism::maxTurns);
  EXPECT_EQ(robot.joints[0].maxTorque, 5);
  // Two masses of 1 kg 2 m apart along y; the arm's inertia is turned by its origin's rpy.
  EXPECT_EQ(robot.links[1].mass, 2);
  EXPECT_TRUE(robot.links[1].com.isApprox(Vec3(0, 1, 1), 1e-12));
  EXPECT_TRUE(robot.links[1].inertia.isApprox(Vec3(2 + 2, 1, 1.5 + 2).asDiagonal().toDenseMatrix(), 1e-12));
  EXPECT_EQ(robot.linkIndex("tool"), 1);
  EXPECT_EQ(robot.imu.link, 1);
  EXPECT_EQ(robot.imu.gyro, Vec3(0, 2, 1));
}

TEST_F(MechanismUrdf, badUrdfsAreNamed) {
  const auto urdfError = [&](std::string from, const std::string& to, std::string table = mastTable) {
    write("mast.servo.json", table);
    std::string text = mast;
    text.replace(text.find(from), from.size(), to);
    return errorOf("mast.urdf", text);
  };
  EXPECT_EQ(urdfError("</joint>", "</link>"), "mast.urdf:6: broken XML (XML_ERROR_MISMATCHED_ELEMENT)");
  EXPECT_EQ(urdfError("<robot name=\"mast\">", "<robot>"), "mast.urdf:1: <robot> lacks name=\"...\"");
  EXPECT_EQ(urdfError("value=\"2\"", "value=\"two\""), "mast.urdf:3: <mass> value is \"two\", no number");
  EXPECT_EQ(urdfError("value=\"2\"", "value=\"nan\""), "mast.urdf:3: <mass> value is \"nan\", no number");
  EXPECT_EQ(urdfError("1 0 0", "1 0"), "mast.urdf:7: <origin> xyz is \"1 0\"; give three numbers");
  EXPECT_EQ(urdfError("continuous", "planar"),
            "mast.urdf:7: joint turn: type is \"planar\"; what can be used is revolute, continuous, "
            "prismatic and fixed");
  EXPECT_EQ(urdfError("continuous", "revolute"), "mast.urdf:7: joint turn: <limit> is missing");
  EXPECT_EQ(urdfError("0 0 2", "0 0 0"), "mast.urdf:7: joint turn: the axis is zero");
  EXPECT_EQ(urdfError("<child link=\"tool\"", "<child link=\"spoon\""),
            "mast.urdf: joint grip: there is no link spoon");
  EXPECT_EQ(urdfError("mast", "mast", "{\"joints\": {}}"),
            "mast.servo.json: joint turn is missing; give it kp, kd and armature");
  EXPECT_EQ(urdfError("mast", "mast", R"({"joints": {"turm": {}}})"),
            "mast.servo.json: joint turm: the URDF has no joint of this name");
  EXPECT_EQ(urdfError("mast", "mast", R"({"joints": {"turn": {"kp": 1, "kd": 0, "armature": 0}}})"),
            "mast.servo.json: joint turn: max_torque or max_speed is not above 0, here or as effort and "
            "velocity in the URDF");
  std::filesystem::remove(folder / "mast.servo.json");
  EXPECT_EQ(errorOf("mast.urdf"), "mast.urdf: has no servo table; write one next to it: mast.servo.json");
  write("mast.servo.yaml", "joints:\n  turn: {kp: 1\n");
  EXPECT_EQ(errorOf("mast.urdf").substr(0, 34), "mast.servo.yaml:3: broken YAML: en");
}

}  // namespace
}  // namespace plumbline
