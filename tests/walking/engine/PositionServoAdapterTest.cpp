#include "walking/engine/PositionServoAdapter.h"

#include <gtest/gtest.h>

#include <cmath>

#include "robot/MechanismFile.h"
#include "servo/BulletRobot.h"

namespace plumbline::walking {
namespace {

class Driver : public testing::Test {
protected:
  const Mechanism nao = findMechanism("nao_v5");
  PositionServoAdapter driver{nao};
  WalkParameters p;

  WalkOutput standing() const {
    p_.posture.hipHeight = 0.22;
    return WalkEngine(p_, driver.humanoid().model()).stand();
  }
  /// Upright, on feet whose sensors read these forces [N].
  ServoMeasurement measuredWith(std::vector<std::vector<double>> footForce) const {
    ServoMeasurement measured;
    measured.position.assign(nao.joints.size(), 0.1);
    measured.acc = Vec3(0, 0, 9.81);
    measured.footForce = std::move(footForce);
    return measured;
  }
  static std::size_t at(int i) { return static_cast<std::size_t>(i); }

private:
  mutable WalkParameters p_;
};

TEST_F(Driver, withoutLeadTargetsAreTheWalks) {
  const WalkOutput output = standing();
  const ServoCommand& command = driver.command(output, p, {});
  EXPECT_EQ(command.target[at(nao.jointIndex("LKneePitch"))], output.angles[lKneePitch]);
  EXPECT_EQ(command.target[at(nao.jointIndex("HeadYaw"))], 0);
  EXPECT_EQ(command.stiffness, std::vector<double>(nao.joints.size(), 1));
}

TEST_F(Driver, stiffnessGoesToTheServos) {
  WalkOutput output = standing();
  output.stiffness[rAnkleRoll] = 0.4;
  const ServoCommand& command = driver.command(output, p, {});
  EXPECT_EQ(command.stiffness[at(nao.jointIndex("RAnkleRoll"))], 0.4);
}

TEST_F(Driver, sensesForcesAndCentresOfPressure) {
  const WalkSensors sensors = driver.sense(measuredWith({{10, 10, 0, 0}, {0, 0, 0, 0}}));
  EXPECT_DOUBLE_EQ(sensors.dt, 0.01);
  EXPECT_EQ(sensors.angles[lHipRoll], 0.1);
  ASSERT_TRUE(sensors.feet);
  EXPECT_FALSE(sensors.feet->shear);
  ASSERT_TRUE(sensors.feet->foot[0]);
  EXPECT_FALSE(sensors.feet->foot[1]) << "nothing touches it";
  EXPECT_EQ(sensors.feet->foot[0]->force, Vec3(0, 0, 20));
  const Vec3 com = nao.links[at(nao.feet[0].link)].com;
  EXPECT_NEAR(sensors.feet->foot[0]->point.x(), 0.07025 - com.x(), 1e-9);
}

TEST_F(Driver, aFootTouchesTheGroundFromOneNewtonOn) {
  const WalkSensors sensors = driver.sense(measuredWith({{0.99, 0, 0, 0}, {0.5, 0.51, 0, 0}}));
  EXPECT_FALSE(sensors.feet->foot[0]);
  EXPECT_TRUE(sensors.feet->foot[1]);
}

TEST_F(Driver, theTorsosAnglesFollowGravityWithinSecondsAndNotWithinCycles) {
  ServoMeasurement measured = measuredWith({{10, 10, 0, 0}, {0, 0, 0, 0}});
  driver.sense(measured);
  measured.acc = Vec3(0, 9.81 * std::sin(0.1), 9.81 * std::cos(0.1));
  Vec2 angles = Vec2::Zero();
  for (int i = 0; i < 100; ++i) angles = driver.sense(measured).torsoAngles;
  // 0.1 rad to the side; 0.4 % of what is missing in each of a hundred cycles.
  EXPECT_NEAR(angles[0], 0.1 * (1 - std::pow(0.996, 100)), 0.004);
  for (int i = 0; i < 2000; ++i) angles = driver.sense(measured).torsoAngles;
  EXPECT_NEAR(angles[0], 0.1, 0.001);
}

/// The torques that hold the robot by statics are those that the servos are found to give.
TEST_F(Driver, loadIsWhatTheServosCarry) {
  const WalkOutput output = standing();
  servo::BulletRobot world(nao);
  const std::vector<double> posture = driver.humanoid().toMechanism(output.angles);
  world.restart(posture);
  world.command(posture);
  for (int i = 0; i < 200; ++i) world.step();
  const servo::ServoReadings& r = world.readings();
  const JointArray measured = driver.humanoid().toModel(r.torque);
  LegLoad load(driver.humanoid().model());
  const JointArray expected =
      load.update(driver.humanoid().toModel(r.position), Vec2::Zero(), {0.5, 0.5}, Vec2::Zero());
  for (const JointId joint : {lKneePitch, rKneePitch, lHipPitch, rHipPitch})
    EXPECT_NEAR(expected[at(joint)], measured[at(joint)], 0.25) << humanoidJointNames[at(joint)];
  EXPECT_GT(std::abs(measured[lKneePitch]), 0.5);
}

/// With the lead the robot stands where it shall; without, it sags.
TEST_F(Driver, leadHoldsThePosture) {
  const WalkOutput output = standing();
  const auto kneeError = [&](double lead) {
    p.servo.loadLead = lead;
    driver.reset();
    servo::BulletRobot world(nao);
    world.restart(driver.humanoid().toMechanism(output.angles));
    for (int i = 0; i < 200; ++i) {
      world.command(driver.command(output, p, {}).target);
      world.step();
    }
    return std::abs(driver.humanoid().toModel(world.readings().position)[lKneePitch] -
                    output.angles[lKneePitch]);
  };
  const double without = kneeError(0), with = kneeError(1);
  EXPECT_GT(without, 0.015);
  EXPECT_LT(with, 0.5 * without);
}

TEST_F(Driver, anArmIsNoWalker) {
  try {
    PositionServoAdapter refused(findMechanism("so101"));
    FAIL();
  } catch (const std::invalid_argument& error) {
    EXPECT_NE(std::string(error.what()).find("so101"), std::string::npos) << error.what();
  }
}

}  // namespace
}  // namespace plumbline::walking
