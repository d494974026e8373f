#include <gtest/gtest.h>

#include <fstream>

#include "robot/MechanismFileFixture.h"

namespace plumbline {
namespace {

using MechanismJson = MechanismFileFixture;

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

TEST_F(MechanismJson, badJsonIsNamed) {
  EXPECT_EQ(errorOf("r.json", ""), "r.json:1: is empty");
  EXPECT_EQ(errorOf("r.json", "{\n\"name\": \"r\",\n}"), "r.json:3: broken JSON");
  EXPECT_EQ(errorOf("r.json", "[1]"), "r.json: it is no object; write { ... }");
  EXPECT_EQ(errorOf("r.json", "{\"name\": \"r\", \"name\": \"s\"}"),
            "r.json: key \"name\" occurs twice in one object");
  EXPECT_EQ(errorOf("r.json", std::string(40, '[')), "r.json: is nested deeper than 16 levels");
  EXPECT_EQ(errorOf("r.json", "{}"), "r.json: name is missing; give the robot's name");
  EXPECT_EQ(errorOf("r.json", pendulum("\"p\"", "\"p.q\"")),
            "r.json: name \"p.q\" is not a valid name; use up to 80 characters without blanks, dots, commas, "
            "slashes, quotes and stars");
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
            "r.json: joint swing: servo: model is \"pid\"; give position, dc_motor or torque");
  EXPECT_EQ(errorOf("r.json", pendulum("\"kp\": 1", "\"model\": \"torque\", \"kp\": 1")),
            "r.json: joint swing: servo: model is torque, which has no gain kp; leave kp out, or give model "
            "position");
  EXPECT_EQ(errorOf("r.json", pendulum("\"lower\"", "\"friction\": -0.1, \"lower\"")),
            "r.json: joint swing: friction is -0.1; give the joint's dry friction in N m, 0 or more");
  EXPECT_EQ(errorOf("r.json", pendulum("\"lower\"", "\"frictoin\": 0.1, \"lower\"")),
            "r.json: joints[0].frictoin: unknown key; did you mean \"friction\"?");
  EXPECT_EQ(errorOf("r.json", pendulum("\"lower\"", "\"damping\": -1, \"lower\"")),
            "r.json: joint swing: damping is -1; give the joint's own damping in N m s/rad, 0 or more");
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
  EXPECT_EQ(errorOf("r.txt", "x"), "r.txt: is no robot's file; give a .json, .urdf, or MuJoCo's .xml file");
  EXPECT_EQ(errorOf("absent.json"), "absent.json: cannot be read: No such file or directory");
}

TEST_F(MechanismJson, unknownKeysAreNamedWithTheNearest) {
  EXPECT_EQ(errorOf("r.json", pendulum("\"lower\"", "\"encode\": \"link\", \"lower\"")),
            "r.json: joints[0].encode: unknown key; did you mean \"encoder\"?");
  EXPECT_EQ(errorOf("r.json", pendulum("\"kp\": 1", "\"models\": \"dc_motor\", \"kp\": 1")),
            "r.json: joints[0].servo.models: unknown key; did you mean \"model\"?");
  EXPECT_EQ(errorOf("r.json", pendulum("\"mass\": 0.5", "\"colour\": 1, \"mass\": 0.5")),
            "r.json: links.arm.colour: unknown key");
  EXPECT_EQ(errorOf("r.json", pendulum("{\"name\": \"p\"", "{\"baselink\": \"arm\", \"name\": \"p\"")),
            "r.json: baselink: unknown key; did you mean \"base_link\"?");
  EXPECT_EQ(errorOf("r.json", pendulum("{\"name\": \"p\"", "{\"rates\": {\"control\": 1}, \"name\": \"p\"")),
            "r.json: rates.control: unknown key");
  EXPECT_EQ(errorOf("r.json", pendulum("{\"name\": \"p\"",
                                       "{\"imu\": {\"link\": \"arm\", \"giro\": [0,0,0]}, \"name\": \"p\"")),
            "r.json: imu.giro: unknown key; did you mean \"gyro\"?");
  EXPECT_EQ(errorOf("r.json", pendulum("{\"name\": \"p\"",
                                       "{\"feet\": [{\"name\": \"L\", \"lnk\": \"arm\"}], \"name\": \"p\"")),
            "r.json: feet[0].lnk: unknown key; did you mean \"link\"?");
  EXPECT_EQ(
      errorOf("r.json", pendulum("{\"name\": \"p\"",
                                 "{\"source\": \"a data sheet\", \"notes\": [\"x\"], \"units\": \"SI\", "
                                 "\"name\": \"p\"")),
      "no error");
}

TEST_F(MechanismJson, everyCutOfAFileIsRefusedOrRead) {
  std::ifstream stream("config/robots/xl330_pendulum.json");
  const std::string text{std::istreambuf_iterator<char>(stream), {}};
  for (std::size_t length = 0; length + 2 < text.size(); length += 7)
    EXPECT_NE(errorOf("cut.json", text.substr(0, length)), "no error") << length;
}

TEST_F(MechanismJson, aLinkMayHaveAShape) {
  const auto with = [](const std::string& more) {
    return pendulum("\"inertia\": [1e-05, 1e-05, 1e-05, 0, 0, 0]",
                    "\"inertia\": [1e-05, 1e-05, 1e-05, 0, 0, 0], " + more);
  };
  const Mechanism box =
      readMechanism(write("r.json", with(R"("shape": {"box": [0.1, 0.2, 0.3]}, "collides": true)")));
  EXPECT_FALSE(box.links[0].shape);
  ASSERT_TRUE(box.links[1].shape);
  EXPECT_EQ(box.links[1].shape->kind, Shape::Kind::box);
  EXPECT_EQ(box.links[1].shape->size, Vec3(0.1, 0.2, 0.3));
  EXPECT_EQ(box.links[1].shape->T_link_shape.translation(), Vec3(0, 0, -0.1)) << "its centre of mass";
  EXPECT_TRUE(box.links[1].collides);
  const Mechanism capsule =
      readMechanism(write("r.json", with(R"("shape": {"capsule": [0.02, 0.3], "centre": [0, 0, 1]})")));
  EXPECT_EQ(capsule.links[1].shape->kind, Shape::Kind::capsule);
  EXPECT_EQ(capsule.links[1].shape->size, Vec3(0.02, 0, 0.3));
  EXPECT_EQ(capsule.links[1].shape->T_link_shape.translation(), Vec3(0, 0, 1));
  EXPECT_FALSE(capsule.links[1].collides);
  EXPECT_EQ(readMechanism(write("r.json", with(R"("shape": {"sphere": 0.05})"))).links[1].shape->size.x(),
            0.05);

  EXPECT_EQ(errorOf("r.json", with(R"("collides": true)")),
            "r.json: link arm: collides, but has no shape; give it one");
  EXPECT_EQ(
      errorOf("r.json", with(R"("shape": {})")),
      "r.json: link arm: shape: give one of box: [x, y, z], sphere: radius and capsule: [radius, length], "
      "in m");
  EXPECT_EQ(errorOf("r.json", with(R"("shape": {"bxo": [1, 1, 1]})")),
            "r.json: links.arm.shape.bxo: unknown key; did you mean \"box\"?");
  EXPECT_EQ(errorOf("r.json", with(R"("shape": {"box": [0.1, 0, 0.3]})")),
            "r.json: link arm: shape: box: an edge is not above 0");
  EXPECT_EQ(errorOf("r.json", with(R"("shape": {"sphere": 1}, "collides": 1)")),
            "r.json: link arm: collides is 1; give true or false");
}

/// A last digit decides when a foot lands; a file that holds an axis to it keeps it.
TEST_F(MechanismJson, anAxisOfLengthOneStaysAsItIsWritten) {
  const Mechanism exact =
      readMechanism(write("r.json", pendulum("[0, 1, 0]", "[0, 0.7071067811865475, -0.7071067811865475]")));
  EXPECT_EQ(exact.joints[0].axis, Vec3(0, 0.7071067811865475, -0.7071067811865475));
  const Mechanism rounded = readMechanism(write("r.json", pendulum("[0, 1, 0]", "[0, 0.7071, -0.7071]")));
  EXPECT_NEAR(rounded.joints[0].axis.norm(), 1, 1e-15);
}

TEST_F(MechanismJson, groupsOfJointsByNameAndByTypeOfServo) {
  const auto twoJoints = [](const std::string& groups, const std::string& type = "") {
    std::string text = pendulum("\"arm\": {",
                                "\"tip\": {\"mass\": 0.1, \"com\": [0, 0, -0.1], \"inertia\": "
                                "[1e-05, 1e-05, 1e-05, 0, 0, 0]}, \"arm\": {");
    const std::string joint = R"(, {"name": "bend", "parent": "arm", "child": "tip", "origin": [0, 0, -0.2],
  "axis": [0, 1, 0], "lower": -3, "upper": 3, "max_torque": 0.8, "max_speed": 19,
  "servo": {"kp": 2, "kd": 0.1, "armature": 0)" +
                              type + "}}]";
    text.replace(text.rfind(']'), 1, joint + groups);
    if (!type.empty()) text.replace(text.find("\"armature\": 0"), 13, "\"armature\": 0" + type);
    return text;
  };
  const Mechanism named =
      readMechanism(write("r.json", twoJoints(R"(, "groups": {"both": ["bend", "swing"]})")));
  ASSERT_EQ(named.groups.size(), 1U);
  EXPECT_EQ(named.groups[0].name, "both");
  EXPECT_EQ(named.groups[0].joints, (std::vector{0, 1}));
  const Mechanism typed = readMechanism(write("t.json", twoJoints("", R"(, "type": "MX28")")));
  ASSERT_EQ(typed.groups.size(), 1U);
  EXPECT_EQ(typed.groups[0].name, "MX28");
  EXPECT_EQ(errorOf("r.json", twoJoints(R"(, "groups": {"both": ["bend", "swang"]})")),
            "r.json: group both: there is no joint swang");
  EXPECT_EQ(errorOf("r.json", twoJoints(R"(, "groups": {"both": ["bend"]})")),
            "r.json: group both has fewer than two motors; give it more joints");
  EXPECT_EQ(errorOf("r.json", twoJoints(R"(, "groups": {"both": ["bend", "bend", "swing"]})")),
            "r.json: group both names joint bend twice");
  EXPECT_EQ(errorOf("r.json", twoJoints(R"(, "groups": {"bend": ["bend", "swing"]})")),
            "r.json: group bend has the name of something else; rename it");
  for (const std::string of : {"bend", "tip"})
    EXPECT_EQ(errorOf("r.json", twoJoints("", ", \"type\": \"" + of + "\"")),
              "r.json: the type of servo " + of + " has the name of something else; rename it");
  EXPECT_EQ(errorOf("r.json", twoJoints(R"(, "groups": {"MX28": ["bend", "swing"]})", R"(, "type": "MX28")")),
            "r.json: group MX28 has the name of a type of servo; rename it");
  EXPECT_EQ(errorOf("r.json", twoJoints(R"(, "groups": {"both": "bend"})")),
            "r.json: groups: group both is no list; write [JOINT, ...]");
}

}  // namespace
}  // namespace plumbline
