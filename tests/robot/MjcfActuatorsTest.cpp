#include "robot/MjcfActuators.h"

#include <gtest/gtest.h>

#include "robot/FeltInertias.h"
#include "robot/MechanismFileFixture.h"

namespace plumbline {
namespace {

class ActuatorsOfMjcf : public MechanismFileFixture {
protected:
  /// Two hinges with these actuators and these defaults.
  static std::string robotWith(const std::string& actuators, const std::string& defaults = "") {
    return R"(<mujoco model="arm"><compiler angle="radian"/><default>)" + defaults + R"(</default><worldbody>
<body name="upper"><inertial pos="0 0 -0.2" mass="2" diaginertia="0.01 0.01 0.01"/>
<joint name="shoulder" axis="0 1 0" armature="0.003" actuatorfrcrange="-50 50"/>
<body name="lower" pos="0 0 -0.4"><inertial pos="0 0 -0.1" mass="1" diaginertia="0.005 0.005 0.005"/>
<joint name="elbow" axis="0 1 0"/></body></body></worldbody><actuator>
)" + actuators +
           "\n</actuator></mujoco>";
  }
  static std::string withElbow(const std::string& shoulder) {
    return robotWith(shoulder + "<position joint=\"elbow\" kp=\"3\"/>");
  }

  Mechanism read(const std::string& text) {
    return readMechanism(write("a.xml", text), [this](const std::string& line) { warnings += line + "\n"; });
  }

  std::string warnings;
};

TEST_F(ActuatorsOfMjcf, aGearMultipliesTorquesAndDividesCommands) {
  const Mechanism robot =
      read(withElbow(R"(<position joint="shoulder" kp="0.05" kv="0.003" gear="10" forcerange="-0.3 0.3"/>)"));
  EXPECT_NEAR(robot.joints[0].servo.kp, 5, 1e-12);
  EXPECT_NEAR(robot.joints[0].servo.kd, 0.3, 1e-12);
  EXPECT_NEAR(robot.joints[0].maxTorque, 3, 1e-12);
  EXPECT_DOUBLE_EQ(
      read(withElbow(R"(<position joint="shoulder" kp="2" gear="-3 0 0 0 0 0"/>)")).joints[0].servo.kp, 18);
  EXPECT_EQ(
      errorOf("a.xml", withElbow(R"(<position joint="shoulder" gear="1 2"/>)")),
      "a.xml:6: gear has a number other than its first that is not 0; a hinge or slide has only the first");
  EXPECT_EQ(errorOf("a.xml", withElbow(R"(<position joint="shoulder" gear="0"/>)")),
            "a.xml:6: gear is 0; leave the actuator out, or give its gear");
}

TEST_F(ActuatorsOfMjcf, defaultsOfOneKindHoldForAllInWhatTheyShare) {
  const Mechanism robot = read(robotWith(R"(<position joint="shoulder"/><position joint="elbow" gear="1"/>)",
                                         R"(<general gear="2"/><position kp="7"/>)"));
  EXPECT_DOUBLE_EQ(robot.joints[0].servo.kp, 28);
  EXPECT_DOUBLE_EQ(robot.joints[1].servo.kp, 7);
}

TEST_F(ActuatorsOfMjcf, ofKvAndDampratioTheNearerOneHolds) {
  const std::string classes =
      R"(<position kp="4" dampratio="1"/><default class="kv"><position kv="0.2"/></default>)";
  const Mechanism robot = read(
      robotWith(R"(<position joint="shoulder" kv="0.5"/><position joint="elbow" class="kv"/>)", classes));
  EXPECT_DOUBLE_EQ(robot.joints[0].servo.kd, 0.5);
  EXPECT_DOUBLE_EQ(robot.joints[1].servo.kd, 0.2);
}

TEST_F(ActuatorsOfMjcf, limitsAreTheStrictestThatHold) {
  const auto limit = [&](const std::string& attributes) {
    return read(withElbow("<position joint=\"shoulder\" " + attributes + "/>")).joints[0].maxTorque;
  };
  EXPECT_DOUBLE_EQ(limit(""), 50) << "the joint's";
  EXPECT_DOUBLE_EQ(limit("forcerange=\"-4 6\""), 6);
  EXPECT_DOUBLE_EQ(limit("forcerange=\"-80 80\""), 50);
  EXPECT_DOUBLE_EQ(limit("forcerange=\"-4 4\" forcelimited=\"false\""), 50);
  EXPECT_DOUBLE_EQ(limit("ctrlrange=\"-1 1\""), 50) << "of angles";
}

TEST_F(ActuatorsOfMjcf, dampingByRatioIsOfTheInertiaAtZero) {
  for (const char* gear : {"1", "5"}) {
    const Mechanism robot = read(withElbow(
        "<position joint=\"shoulder\" kp=\"40\" dampratio=\"0.7\" gear=\"" + std::string(gear) + "\"/>"));
    // Both links about the shoulder, and its rotor.
    const double inertia = 0.003 + 0.01 + 2 * 0.04 + 0.005 + 1 * 0.25;
    EXPECT_NEAR(feltInertias(robot, {0, 0})[0], inertia, 1e-12);
    EXPECT_NEAR(robot.joints[0].servo.kd, 0.7 * 2 * std::sqrt(robot.joints[0].servo.kp * inertia), 1e-12);
  }
  EXPECT_EQ(errorOf("a.xml", withElbow(R"(<position joint="shoulder" kv="1" dampratio="1"/>)")),
            "a.xml:6: has kv and dampratio; give one of them");
}

TEST_F(ActuatorsOfMjcf, aMotorTakesTorquesAlone) {
  const Mechanism robot = read(withElbow(R"(<motor joint="shoulder" gear="20" ctrlrange="-1 1"/>)"));
  EXPECT_DOUBLE_EQ(robot.joints[0].servo.kp, 0);
  EXPECT_DOUBLE_EQ(robot.joints[0].servo.kd, 0);
  EXPECT_DOUBLE_EQ(robot.joints[0].maxTorque, 20);
  EXPECT_THROW(requirePositionServos(robot), MechanismError);
  EXPECT_NO_THROW(requirePositionServos(read(withElbow(R"(<position joint="shoulder"/>)"))));
}

TEST_F(ActuatorsOfMjcf, aVelocityActuatorTakesSpeeds) {
  const Mechanism robot = read(withElbow(R"(<velocity joint="shoulder" kv="0.5" gear="2"/>)"));
  EXPECT_DOUBLE_EQ(robot.joints[0].servo.kp, 0);
  EXPECT_DOUBLE_EQ(robot.joints[0].servo.kd, 2);
}

TEST_F(ActuatorsOfMjcf, aPositionAVelocityAndAMotorAreOneServo) {
  const Mechanism robot = read(withElbow(
      R"(<position joint="shoulder" kp="30"/><velocity joint="shoulder" kv="2"/><motor joint="shoulder"/>)"));
  EXPECT_DOUBLE_EQ(robot.joints[0].servo.kp, 30);
  EXPECT_DOUBLE_EQ(robot.joints[0].servo.kd, 2);
  EXPECT_EQ(errorOf("a.xml", withElbow(R"(<position joint="shoulder"/><position joint="shoulder"/>)")),
            "a.xml:6: joint shoulder has two actuators of this kind; keep one");
  EXPECT_EQ(
      errorOf("a.xml", withElbow(R"(<position joint="shoulder" kv="1"/><velocity joint="shoulder"/>)")),
      "a.xml:6: joint shoulder has a <velocity> and a position actuator with damping of its own; set kv or "
      "dampratio of the latter to 0");
  EXPECT_EQ(errorOf("a.xml",
                    withElbow(R"(<position joint="shoulder" forcerange="-1 1"/><motor joint="shoulder"/>)")),
            "a.xml:6: joint shoulder has several actuators, and one has a limit; give the joint "
            "actuatorfrcrange instead");
}

TEST_F(ActuatorsOfMjcf, aGeneralActuatorIsWhichOfThemItsNumbersMake) {
  const auto servo = [&](const std::string& attributes) {
    return read(withElbow("<general joint=\"shoulder\" " + attributes + "/>")).joints[0].servo;
  };
  EXPECT_DOUBLE_EQ(servo(R"(biastype="affine" gainprm="12" biasprm="0 -12 -0.2" gear="2")").kp, 48);
  EXPECT_DOUBLE_EQ(servo(R"(biastype="affine" gainprm="12" biasprm="0 -12 -0.2" gear="2")").kd, 0.8);
  EXPECT_NEAR(servo(R"(biastype="affine" gainprm="12" biasprm="0 -12 1")").kd, 2 * std::sqrt(12 * 0.348),
              1e-9)
      << "a positive number is a ratio";
  EXPECT_DOUBLE_EQ(servo(R"(biastype="affine" gainprm="3" biasprm="0 0 -3")").kd, 3);
  EXPECT_DOUBLE_EQ(servo(R"(gainprm="3")").kp, 0);
  EXPECT_EQ(
      errorOf("a.xml",
              withElbow(R"(<general joint="shoulder" biastype="affine" gainprm="12" biasprm="0 -1 0"/>)")),
      "a.xml:6: <general> is no position servo (gainprm kp, biasprm 0 -kp -kv), no speed servo (gainprm "
      "kv, biasprm 0 0 -kv) and no motor (biastype none)");
}

TEST_F(ActuatorsOfMjcf, whatTheModelDoesNotHaveIsSaid) {
  const auto error = [&](const std::string& actuator) { return errorOf("a.xml", withElbow(actuator)); };
  EXPECT_EQ(
      error(R"(<position tendon="both"/>)"),
      "a.xml:6: an actuator acts on a tendon, which the nominal model does not have; give joint=\"...\" "
      "instead, and <equality> <joint> for joints that move together");
  EXPECT_EQ(error(R"(<position joint="sholder"/>)"),
            "a.xml:6: there is no joint sholder; did you mean \"shoulder\"?");
  EXPECT_EQ(error(R"(<damper joint="shoulder" kv="1"/>)"),
            "a.xml:6: <damper> is no actuator that can be used; give position, velocity, motor or general");
  EXPECT_EQ(error(R"(<general joint="shoulder" dyntype="filter"/>)"),
            "a.xml:6: dyntype is \"filter\", which the nominal model does not have; leave it out");
  EXPECT_EQ(error(R"(<position joint="shoulder" kp="-1"/>)"),
            "a.xml:6: gain is -1, damping 0; give a gain above 0 and damping of 0 or more");
  read(withElbow(R"(<position joint="shoulder" timeconst="0.05"/>)"));
  EXPECT_NE(warnings.find(
                "a.xml:6: timeconst is not in the nominal model; expect command_lag of 0.05 s at shoulder"),
            std::string::npos)
      << warnings;
}

}  // namespace
}  // namespace plumbline
