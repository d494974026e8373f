#include "robot/MechanismFile.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>
#include <filesystem>
#include <fstream>

#include "robot/Mechanism.h"

namespace plumbline {
namespace {

namespace fs = std::filesystem;

class MechanismFile : public testing::Test {
protected:
  MechanismFile() : folder(fs::path(testing::TempDir()) / ("mechanism" + std::to_string(counter++))) {
    fs::create_directories(folder);
  }
  ~MechanismFile() override { fs::remove_all(folder); }

  std::string write(const std::string& name, const std::string& text) const {
    std::ofstream(folder / name) << text;
    return (folder / name).string();
  }

  /// The error of reading a file of that text, its folder taken off.
  std::string errorOf(const std::string& name, const std::string& text) const {
    write(name, text);
    return errorOf(name);
  }
  std::string errorOf(const std::string& name) const {
    try {
      readMechanism((folder / name).string());
    } catch (const MechanismError& error) {
      std::string what = error.what();
      for (std::size_t at; (at = what.find(folder.string() + "/")) != std::string::npos;)
        what.erase(at, folder.string().size() + 1);
      return what;
    }
    return "no error";
  }

  const fs::path folder;
  static inline int counter = static_cast<int>(getpid());
};

/// A pendulum in JSON; {place} marks are replaced by tests.
std::string pendulum(const std::string& from = "", const std::string& to = "") {
  std::string text = R"({"name": "p", "links": {
 "stand": {"mass": 1.0, "com": [0, 0, 0], "inertia": [0.001, 0.001, 0.001, 0, 0, 0]},
 "arm": {"mass": 0.5, "com": [0, 0, -0.1], "inertia": [1e-05, 1e-05, 1e-05, 0, 0, 0]}},
 "joints": [{"name": "swing", "parent": "stand", "child": "arm", "origin": [0, 0, 0.3], "axis": [0, 1, 0],
  "lower": -3, "upper": 3, "max_torque": 0.8, "max_speed": 19, "servo": {"kp": 1, "kd": 0.1, "armature": 0}}]})";
  if (const std::size_t at = text.find(from); !from.empty() && at != std::string::npos)
    text.replace(at, from.size(), to);
  return text;
}

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
  std::string text{std::istreambuf_iterator<char>(stream), {}};
  for (const char* key : {"\"driven_by\":", "\"feet\":"}) {
    ASSERT_NE(text.find(key), std::string::npos);
    text.replace(text.find(key), 2, "\"x");
  }
  const Mechanism nao = readMechanism(write("old.json", text));
  EXPECT_EQ(nao.joints[static_cast<std::size_t>(nao.jointIndex("RHipYawPitch"))].driver,
            nao.jointIndex("LHipYawPitch"));
  ASSERT_EQ(nao.feet.size(), 2u);
  EXPECT_EQ(nao.feet[0].link, nao.linkIndex("l_ankle"));
  EXPECT_NEAR(nao.feet[0].soleSize.x(), 0.1005, 1e-12);
  EXPECT_NEAR(nao.feet[0].soleCentre.z() - nao.feet[0].soleSize.z() / 2, -0.04511, 1e-12);
}

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

TEST_F(MechanismFile, aUrdfWithItsTableIsTheSameRobot) {
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

TEST_F(MechanismFile, whatIsFixedInAUrdfBecomesOneLink) {
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

TEST_F(MechanismFile, badUrdfsAreNamed) {
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
  fs::remove(folder / "mast.servo.json");
  EXPECT_EQ(errorOf("mast.urdf"), "mast.urdf: has no servo table; write one beside it: mast.servo.json");
  write("mast.servo.yaml", "joints:\n  turn: {kp: 1\n");
  EXPECT_EQ(errorOf("mast.urdf").substr(0, 34), "mast.servo.yaml:3: broken YAML: en");
}

TEST_F(MechanismFile, badJsonIsNamed) {
  EXPECT_EQ(errorOf("r.json", ""), "r.json:1: is empty");
  EXPECT_EQ(errorOf("r.json", "{\n\"name\": \"r\",\n}"), "r.json:3: broken JSON");
  EXPECT_EQ(errorOf("r.json", "[1]"), "r.json: it is no object; write { ... }");
  EXPECT_EQ(errorOf("r.json", "{\"name\": \"r\", \"name\": \"s\"}"),
            "r.json: key \"name\" occurs twice in one object");
  EXPECT_EQ(errorOf("r.json", std::string(40, '[')), "r.json: is nested deeper than 16 levels");
  EXPECT_EQ(errorOf("r.json", "{}"), "r.json: name is missing; give the robot's name");
  EXPECT_EQ(
      errorOf("r.json", pendulum("\"p\"", "\"p.q\"")),
      "r.json: name \"p.q\" cannot be a name; use up to 80 characters without blanks, dots, commas, slashes, "
      "quotes and stars");
  EXPECT_EQ(errorOf("r.json", pendulum("\"mass\": 0.5", "\"mass\": 0")),
            "r.json: link arm: mass is 0; give a mass in kg above 0");
  EXPECT_EQ(errorOf("r.json", pendulum("\"mass\": 0.5", "\"mass\": \"heavy\"")),
            "r.json: link arm: mass is \"heavy\", no number");
  EXPECT_EQ(errorOf("r.json", pendulum("\"mass\": 0.5, ", "")),
            "r.json: link arm: mass is missing; give a mass in kg above 0");
  EXPECT_EQ(errorOf("r.json", pendulum("[0, 0, -0.1]", "[0, 0]")),
            "r.json: link arm: com is a list of 2; give [x, y, z] in m");
  EXPECT_EQ(errorOf("r.json", pendulum("1e-05, 1e-05, 1e-05", "1e-05, -1e-05, 1e-05")),
            "r.json: link arm: the inertia is not positive definite; check order and signs");
  EXPECT_EQ(errorOf("r.json", pendulum("1e-05, 1e-05, 1e-05", "1e999, 1e-05, 1e-05")),
            "r.json: holds a number that is too large");
  EXPECT_EQ(errorOf("r.json", pendulum("[0, 1, 0]", "[0, 1, 1]")),
            "r.json: joint swing: axis has length 1.41421; give it length 1");
  EXPECT_EQ(errorOf("r.json", pendulum("\"lower\": -3", "\"lower\": 4")),
            "r.json: joint swing: lower 4 is not below upper 3");
  EXPECT_EQ(errorOf("r.json", pendulum("\"child\": \"arm\"", "\"child\": \"leg\"")),
            "r.json: joint swing: there is no link leg");
  EXPECT_EQ(errorOf("r.json", pendulum("\"child\": \"arm\"", "\"child\": \"stand\"")),
            "r.json: joint swing hangs in a ring of links; a robot is a tree");
  EXPECT_EQ(errorOf("r.json", pendulum("\"kp\": 1", "\"kp\": 0")),
            "r.json: joint swing: servo: kp is 0; give the servo's gain in N m/rad, above 0");
  EXPECT_EQ(errorOf("r.json", pendulum("\"armature\": 0", "\"armature\": -1")),
            "r.json: joint swing: servo: armature is -1; give the rotor's inertia at the joint in kg m^2, 0 "
            "or more");
  EXPECT_EQ(errorOf("r.json", pendulum("\"kp\": 1", "\"model\": \"pid\", \"kp\": 1")),
            "r.json: joint swing: servo: model is \"pid\"; give position or dc_motor");
  EXPECT_EQ(
      errorOf("r.json", pendulum("\"kp\": 1", "\"model\": \"dc_motor\", \"kp\": 1")),
      "r.json: joint swing: servo: dc_motor is missing; give {kt, R, vin, error_gain, kp_firmware, max_pwm}");
  EXPECT_EQ(errorOf("r.json", pendulum("\"lower\"", "\"driven_by\": \"none\", \"lower\"")),
            "r.json: joint swing is driven by none, which is no joint");
  EXPECT_EQ(errorOf("r.json", pendulum("\"lower\"", "\"encoder\": \"both\", \"lower\"")),
            "r.json: joint swing: encoder is \"both\"; give motor or link");
  EXPECT_EQ(errorOf("r.json", pendulum("{\"name\": \"p\"", "{\"base_link\": \"arm\", \"name\": \"p\"")),
            "r.json: base_link is arm, but the joints start at stand");
  EXPECT_EQ(
      errorOf("r.json", pendulum("{\"name\": \"p\"", "{\"fsr\": {\"LFoot.Toe\": [0,0,0]}, \"name\": \"p\"")),
      "r.json: fsr: \"LFoot.Toe\" is no sensor; write FOOT.CORNER, corner FrontLeft, FrontRight, RearLeft or "
      "RearRight");
  EXPECT_EQ(errorOf("r.txt", "x"), "r.txt: is no robot's file; give a .json or .urdf file");
  EXPECT_EQ(errorOf("absent.json"), "absent.json: cannot be read: No such file or directory");
}

TEST_F(MechanismFile, everyCutOfAFileIsRefusedOrRead) {
  std::ifstream stream("config/robots/xl330_pendulum.json");
  const std::string text{std::istreambuf_iterator<char>(stream), {}};
  for (std::size_t length = 0; length + 2 < text.size(); length += 7)
    EXPECT_NE(errorOf("cut.json", text.substr(0, length)), "no error") << length;
}

TEST_F(MechanismFile, robotsAreFoundByName) {
  try {
    findMechanism("nao_v9");
    FAIL();
  } catch (const MechanismError& error) {
    EXPECT_STREQ(
        error.what(),
        "config/robots: no robot nao_v9; there are nao_v5, so101, xl330_pendulum; give the robot's file");
  }
  EXPECT_THROW(findMechanism("../robots/nao_v5"), MechanismError);
}

}  // namespace
}  // namespace plumbline
