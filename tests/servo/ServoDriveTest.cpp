#include "servo/ServoDrive.h"

#include <gtest/gtest.h>

#include <cmath>

namespace plumbline::servo {
namespace {

constexpr double h = 0.001;

JointPlant servo() {
  JointPlant drive;
  drive.servo.kp = 20;
  drive.servo.kd = 0.4;
  drive.servo.armature = 0.01;
  drive.maxTorque = 2;
  drive.maxSpeed = 10;
  return drive;
}

/// Begins a step there, commanded to `target`.
ServoDrive begun(const JointPlant& plant, double target, double q, double speed, bool detailed = true) {
  ServoDrive drive(plant, detailed);
  drive.start(q);
  drive.command(target);
  drive.begin(h, {q, speed}, {q, speed});
  return drive;
}

TEST(ServoDrive, theContractsLawImplicitOrByTheTrapezoid) {
  const ServoDrive implicit = begun(servo(), 0.05, 0, 1, false);
  EXPECT_DOUBLE_EQ(implicit.torque(1), 20 * (0.05 - h) - 0.4) << "where it is after the step";
  const ServoDrive trapezoid = begun(servo(), 0.05, 0, 1);
  EXPECT_DOUBLE_EQ(trapezoid.torque(3), 20 * 0.05 - 0.4 * 2) << "the mean of both speeds";
}

TEST(ServoDrive, errorsWithinTheDeadBandAreNone) {
  JointPlant plant = servo();
  plant.deadBand = 0.02;
  EXPECT_DOUBLE_EQ(begun(plant, 0.019, 0, 0).torque(0), 0);
  EXPECT_DOUBLE_EQ(begun(plant, -0.05, 0, 0).torque(0), -20 * 0.03);
  plant.deadBandSteps = true;
  EXPECT_DOUBLE_EQ(begun(plant, -0.05, 0, 0).torque(0), -20 * 0.05);
}

TEST(ServoDrive, gainsOffsetsAndTheEncodersErrorShift) {
  JointPlant plant = servo();
  plant.offset = 0.03;
  plant.encoderAmplitude = 0.02;
  plant.encoderPhase = 0.1;
  const double shown = 0.47 + 0.02 * std::sin(0.57);
  EXPECT_DOUBLE_EQ(begun(plant, 0.5, 0.5, 0).measured({0.5, 0}, {0.5, 0}), shown);
  EXPECT_DOUBLE_EQ(begun(plant, 0.5, 0.5, 0).torque(0), 20 * (0.5 - shown));
}

TEST(ServoDrive, fullTorqueFadesWithTheSpeedAfterTheStep) {
  ServoDrive drive = begun(servo(), 1, 0, 8.9);
  EXPECT_TRUE(drive.limitAt(8.9));
  EXPECT_DOUBLE_EQ(drive.torque(8.9), 2);
  EXPECT_FALSE(drive.limitAt(8.9));
  EXPECT_TRUE(drive.limitAt(9.5)) << "then it is on the line that ends at 10 rad/s";
  EXPECT_DOUBLE_EQ(drive.torque(9.5), 1);
  EXPECT_NEAR(drive.torque(9.2), 1.6, 1e-12);
  EXPECT_FALSE(drive.limitAt(9.2));
  EXPECT_TRUE(drive.limitAt(10.1)) << "and none beyond";
  EXPECT_DOUBLE_EQ(drive.torque(10.1), 0);
  EXPECT_FALSE(drive.limitAt(10.1));
}

TEST(ServoDrive, torqueFadesOverTheLastTenthBelowAnyTopSpeed) {
  JointPlant plant = servo();
  plant.maxSpeed = 8;
  ServoDrive drive = begun(plant, 1, 0, 7);
  EXPECT_TRUE(drive.limitAt(7));
  EXPECT_FALSE(drive.limitAt(7.1));
  EXPECT_TRUE(drive.limitAt(7.3)) << "the line begins at 7.2 rad/s";
  EXPECT_NEAR(drive.torque(7.2), 2, 1e-12);
  EXPECT_NEAR(drive.torque(7.6), 1, 1e-12);
  EXPECT_NEAR(drive.torque(8), 0, 1e-12);
}

TEST(ServoDrive, withoutDetailTheLimitIsThatOfTheSpeedBefore) {
  ServoDrive drive = begun(servo(), 1, 0, 9.5, false);
  EXPECT_TRUE(drive.limitAt(9.9));
  EXPECT_DOUBLE_EQ(drive.torque(9.9), 1);
  EXPECT_FALSE(drive.limitAt(9.9));
}

TEST(ServoDrive, heatTakesTheLimitAway) {
  JointPlant plant = servo();
  plant.deratingPerJoule = 0.25;
  ServoDrive drive = begun(plant, 1, 0, 0);
  ASSERT_TRUE(drive.limitAt(0));
  for (int i = 0; i < 500; ++i) {
    drive.begin(h, {0, 0}, {0, 0});
    drive.limitAt(0);
    drive.end(0);
  }
  drive.begin(h, {0, 0}, {0, 0});
  drive.limitAt(0);
  // d(torque^2 heat)/dt with torque = 2 (1 - heat / 4): heat = 4 t / (1 + t).
  EXPECT_NEAR(drive.torque(0), 2 * (1 - (4 * 0.5 / 1.5) / 4), 1e-3);
  plant.heatIsWork = true;
  ServoDrive still = begun(plant, 1, 0, 0);
  for (int i = 0; i < 500; ++i) {
    still.begin(h, {0, 0}, {0, 0});
    still.limitAt(0);
    still.end(0);
  }
  EXPECT_DOUBLE_EQ(still.torque(0), 2) << "what does not turn does no work";
}

TEST(ServoDrive, aDcMotorsDutyEndsAndItsMotorBrakesOn) {
  JointPlant plant;
  plant.servo.model = Servo::Model::dcMotor;
  plant.servo.kt = 0.5;
  plant.servo.R = 2;
  plant.servo.vin = 12;
  plant.servo.errorGain = 0.1;
  plant.servo.kpFirmware = 10;
  plant.servo.maxPwm = 0.8;
  plant.supplyFactor = 0.5;
  plant.maxTorque = 3;
  ServoDrive drive = begun(plant, 0.4, 0, 1);
  EXPECT_DOUBLE_EQ(drive.torque(1), 0.5 / 2 * (6 * 0.4 - 0.5));
  EXPECT_FALSE(drive.limitAt(1));
  drive = begun(plant, 2, 0, 1);
  EXPECT_TRUE(drive.limitAt(1));
  EXPECT_DOUBLE_EQ(drive.torque(1), 0.5 / 2 * (6 * 0.8 - 0.5));
  EXPECT_FALSE(drive.limitAt(1)) << "it has no other limit";
  plant.torqueFactor = 0.1;
  drive = begun(plant, 2, 0, 1);
  EXPECT_TRUE(drive.limitAt(1));
  EXPECT_TRUE(drive.limitAt(1));
  EXPECT_NEAR(drive.torque(1), 0.3, 1e-12);
}

TEST(ServoDrive, aPositionServosDutyEndsAndItsMotorBrakesOn) {
  JointPlant plant = servo();
  plant.fullDutyTorque = 3;
  for (const bool detailed : {false, true}) {
    ServoDrive drive = begun(plant, 0.1, 0, 1, detailed);
    EXPECT_FALSE(drive.limitAt(1)) << "an error that asks for less";
    drive = begun(plant, 1, 0, 1, detailed);
    EXPECT_TRUE(drive.limitAt(1));
    EXPECT_DOUBLE_EQ(drive.torque(1), 3 - 0.4) << "more than its largest torque";
    EXPECT_FALSE(drive.limitAt(1)) << "it has no other limit";
    drive = begun(plant, -1, 0, 5, detailed);
    EXPECT_TRUE(drive.limitAt(5));
    EXPECT_DOUBLE_EQ(drive.torque(5), -3 - 2) << "braking, the back EMF helps";
  }
}

TEST(ServoDrive, aProfileKeepsItsAccelerationAndArrives) {
  JointPlant plant = servo();
  plant.accelerationLimit = 10;
  ServoDrive drive(plant, true);
  drive.start(0);
  drive.command(0.4);
  // Half the way in 0.2 s at 10 rad/s^2: the law's torque tells where the set point is.
  const auto setPoint = [&] { return drive.torque(0) / 20; };
  std::vector<double> way;
  for (int i = 0; i < 450; ++i) {
    drive.begin(h, {0, 0}, {0, 0});
    way.push_back(setPoint());
  }
  EXPECT_NEAR(way[99], 0.05, 1e-3);
  EXPECT_NEAR(way[199], 0.2, 3e-3);
  EXPECT_NEAR(way[299], 0.35, 5e-3);
  EXPECT_DOUBLE_EQ(way.back(), 0.4);
}

TEST(ServoDrive, aProfileIsNoFasterThanTheMotorOrItsOwnSpeed) {
  const auto setPointAfter = [](double maxSpeed, double profileSpeed) {
    JointPlant plant = servo();
    plant.accelerationLimit = 1000;
    plant.maxSpeed = maxSpeed;
    plant.profileSpeed = profileSpeed;
    plant.maxTorque = 1e6;
    ServoDrive drive(plant, true);
    drive.start(0);
    drive.command(10);
    for (int i = 0; i < 1000; ++i) drive.begin(h, {0, 0}, {0, 0});
    return drive.torque(0) / 20;
  };
  // The speed is reached within a few milliseconds.
  EXPECT_NEAR(setPointAfter(2, 0), 2, 0.01);
  EXPECT_NEAR(setPointAfter(2, 0.5), 0.5, 0.01);
  EXPECT_NEAR(setPointAfter(0.5, 2), 0.5, 0.01);
}

TEST(ServoDrive, aLagComesNearExponentially) {
  JointPlant plant = servo();
  plant.commandLag = 0.05;
  ServoDrive drive(plant, true);
  drive.start(0.1);
  drive.command(0.5);
  double sum = 0;
  for (int i = 0; i < 100; ++i) {
    drive.begin(h, {0.1, 0}, {0.1, 0});
    sum += drive.torque(0) / 20 * h;
  }
  EXPECT_NEAR(sum, 0.4 * (100 * h - 0.05 * (1 - std::exp(-100 * h / 0.05))), 1e-12);
  drive.start(0.2);
  drive.begin(h, {0.2, 0}, {0.2, 0});
  EXPECT_DOUBLE_EQ(drive.torque(0), 0) << "at rest again";
}

TEST(ServoDrive, dryFrictionOfEachKind) {
  JointPlant plant = servo();
  plant.coulomb = 0.3;
  plant.stribeck = 0.2;
  plant.stribeckSpeed = 0.1;
  EXPECT_DOUBLE_EQ(begun(plant, 0, 0, 0).dryLimit().forward, 0.5);
  EXPECT_DOUBLE_EQ(begun(plant, 0, 0, 0.1).dryLimit().forward, 0.3 + 0.2 / std::exp(1.0));
  plant = servo();
  plant.loadFriction = 0.5;
  ServoDrive drive = begun(plant, 0.05, 0, 0);
  EXPECT_DOUBLE_EQ(drive.dryLimit().forward, 0) << "nothing has been transmitted yet";
  drive.end(0.02);  // 1 N m less what the damping takes and what turns the rotor by 20 rad/s^2
  EXPECT_NEAR(drive.dryLimit().forward, 0.5 * (1 - 0.4 * 0.01 - 0.01 * 20), 1e-12);
  plant.loadIs = JointPlant::Load::linkTorque;
  ServoDrive behind = begun(plant, 0.05, 0, 0);
  behind.end(0.02, -0.1);
  EXPECT_NEAR(behind.dryLimit().forward, 0.5 * (1 - 0.4 * 0.01 - 0.01 * 20 - 0.1), 1e-12);
  plant.loadIs = JointPlant::Load::motorTorque;
  ServoDrive motor = begun(plant, 0.05, 0, 0);
  motor.end(0.02, -0.1);
  EXPECT_NEAR(motor.dryLimit().forward, 0.5 * (1 - 0.4 * 0.01), 1e-12);
}

}  // namespace
}  // namespace plumbline::servo
