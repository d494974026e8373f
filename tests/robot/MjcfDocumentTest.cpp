#include "robot/MjcfDocument.h"

#include <gtest/gtest.h>

#include "robot/MechanismFileFixture.h"

namespace plumbline {
namespace {

class IncludedMjcf : public MechanismFileFixture {
protected:
  IncludedMjcf() { std::filesystem::create_directories(folder / "parts"); }

  static std::string around(const std::string& text) { return "<mujoco>\n" + text + "\n</mujoco>"; }
  static std::string include(const std::string& file) { return "<include file=\"" + file + "\"/>"; }
  static std::string body(const std::string& joint = R"(<joint name="J" axis="0 1 0"/>)") {
    return "<body name=\"arm\">\n" + joint +
           "<inertial pos=\"0 0 0\" mass=\"1\" diaginertia=\"1 1 1\"/></body>";
  }
  static constexpr const char* servo = R"(<actuator><position joint="J" kp="4"/></actuator>)";

  const std::string main = around(include("parts/robot.xml"));
};

TEST_F(IncludedMjcf, whatIsIncludedStandsInItsPlace) {
  write("parts/robot.xml",
        around("<worldbody>" + include("arm.xml") + "</worldbody>" + include("servo.xml")));
  write("parts/arm.xml", "<mujocoinclude>" + body() + "</mujocoinclude>");
  write("parts/servo.xml", around(servo));
  const Mechanism robot = readMechanism(write("scene.xml", main), {});
  ASSERT_EQ(robot.joints.size(), 1U);
  EXPECT_DOUBLE_EQ(robot.joints[0].servo.kp, 4);
}

TEST_F(IncludedMjcf, aNameMayAlsoBeFromTheMainFilesFolder) {
  write("parts/robot.xml", around("<worldbody>" + body() + "</worldbody>" + include("parts/servo.xml")));
  write("parts/servo.xml", around(servo));
  EXPECT_EQ(readMechanism(write("scene.xml", main), {}).joints.size(), 1U);
}

TEST_F(IncludedMjcf, aNameThatMeansTwoFilesIsRefused) {
  write("parts/robot.xml", around("<worldbody>" + body() + "</worldbody>\n" + include("servo.xml")));
  write("parts/servo.xml", around(servo));
  write("servo.xml", around(servo));
  EXPECT_EQ(
      errorOf("scene.xml", main),
      "parts/robot.xml:4: <include> names servo.xml, which is in this file's folder and in the main file's; "
      "rename one");
}

TEST_F(IncludedMjcf, errorsNameThePartAndItsLine) {
  write("parts/robot.xml", around("<worldbody>" + body(R"(<joint name="J" type="ball"/>)") + "</worldbody>"));
  EXPECT_EQ(errorOf("scene.xml", main),
            "parts/robot.xml:3: type is \"ball\"; what can be used is hinge, slide and a free base");
  write("parts/robot.xml", "<mujoco><worldbody></mujoco>");
  EXPECT_EQ(errorOf("scene.xml", main), "parts/robot.xml:1: broken XML (XML_ERROR_MISMATCHED_ELEMENT)");
}

TEST_F(IncludedMjcf, onlyTheFolderOfTheModelIsRead) {
  const std::string outside =
      ", which is outside the model's folder; copy it into that, or save the whole model "
      "with MuJoCo (mj_saveLastXML)";
  for (const std::string name : {"../x.xml", "/etc/passwd", "parts/../../x.xml"})
    EXPECT_EQ(errorOf("scene.xml", around(include(name))), "scene.xml:2: <include> names " + name + outside);
  std::filesystem::create_symlink("/etc/hostname", folder / "link.xml");
  EXPECT_EQ(errorOf("scene.xml", around(include("link.xml"))),
            "scene.xml:2: <include> names link.xml" + outside);
  // Out of a folder of the model and into another one of it.
  std::filesystem::create_directories(folder / "servos");
  write("parts/robot.xml", around("<worldbody>" + body() + "</worldbody>" + include("../servos/servo.xml")));
  write("servos/servo.xml", around(servo));
  EXPECT_EQ(readMechanism(write("scene.xml", main), {}).joints.size(), 1U);
}

TEST_F(IncludedMjcf, whatCannotBeIncludedIsNamed) {
  write("parts/robots.xml", around(""));
  EXPECT_EQ(errorOf("scene.xml", around(include("robot.xml"))),
            "scene.xml:2: <include> names robot.xml, which does not exist");
  write("robots.xml", around(""));
  EXPECT_EQ(errorOf("scene.xml", around(include("robot.xml"))),
            "scene.xml:2: <include> names robot.xml, which does not exist; did you mean \"robots.xml\"?");
  EXPECT_EQ(errorOf("scene.xml", around("<include/>")), "scene.xml:2: <include> lacks file=\"...\"");
  EXPECT_EQ(errorOf("scene.xml", around(include("parts/robots.xml") + include("parts/robots.xml"))),
            "scene.xml:2: <include> names parts/robots.xml a second time; include it once");
}

TEST_F(IncludedMjcf, ringsAndDepthsEnd) {
  write("parts/robot.xml", around(include("../scene.xml")));
  EXPECT_EQ(errorOf("scene.xml", main),
            "parts/robot.xml:2: <include> names parts/../scene.xml a second time; include it once");
  for (int i = 0; i < 20; ++i)
    write("deep" + std::to_string(i) + ".xml", around(include("deep" + std::to_string(i + 1) + ".xml")));
  EXPECT_EQ(errorOf("deep0.xml"),
            "deep16.xml:2: files are included too deeply, more than 16 within each other");
}

}  // namespace
}  // namespace plumbline
