#include "gap/replay/ServoLaw.h"

#include <gtest/gtest.h>

#include <cmath>

#include "../TwoJointArm.h"
#include "gap/diagnosis/Explanation.h"
#include "gap/effects/Effects.h"
#include "robot/MechanismFile.h"

namespace plumbline::gap {
namespace {

double torque(const JointPlant& plant, double command, double x, double w, double share = 1) {
  return servoLine(plant, command, share, 0, x, w, 1).at(x, w);
}

TEST(ServoLawTest, positionServoAsInTheContract) {
  const JointPlant plant = nominalPlant(twoJointArm()).joints[0];
  EXPECT_DOUBLE_EQ(torque(plant, 0.1, 0.02, 0.5), 20 * 0.08 - 0.4 * 0.5);
  EXPECT_DOUBLE_EQ(torque(plant, 1, 0, 0), 3);
  EXPECT_DOUBLE_EQ(torque(plant, -1, 0, 0), -3);
  EXPECT_DOUBLE_EQ(torque(plant, 1, 0, 0, 0.5), 1.5);
  EXPECT_DOUBLE_EQ(torque(plant, 1, 0, 0, 0), 0);
}

TEST(ServoLawTest, torqueFadesOverTheLastTenthOfTheSpeed) {
  const JointPlant plant = nominalPlant(twoJointArm()).joints[0];
  EXPECT_NEAR(torque(plant, 9, 0, 6.3), 3, 1e-12);
  EXPECT_NEAR(torque(plant, 9, 0, 6.65), 1.5, 1e-12);
  EXPECT_NEAR(torque(plant, 9, 0, 7.5), 0, 1e-12);
  EXPECT_DOUBLE_EQ(torque(plant, -9, 0, 7.5), -3);  // braking is not limited
}

TEST(ServoLawTest, deadBandInBothForms) {
  JointPlant plant = nominalPlant(twoJointArm()).joints[0];
  plant.deadBand = 0.02;
  EXPECT_DOUBLE_EQ(torque(plant, 0.015, 0, 0), 0);
  EXPECT_NEAR(torque(plant, 0.05, 0, 0), 20 * 0.03, 1e-12);
  plant.deadBandSteps = true;
  EXPECT_NEAR(torque(plant, 0.05, 0, 0), 20 * 0.05, 1e-12);
}

TEST(ServoLawTest, dcMotorAsInTheContract) {
  const Mechanism pendulum = findMechanism("xl330_pendulum");
  const JointPlant plant = nominalPlant(pendulum).joints[0];
  const double kt = 0.38042, R = 3.38007, vin = 7.4, duty = 400 * 0.00287738 * 0.3;
  EXPECT_NEAR(torque(plant, 0.3, 0, 2), kt * (vin * duty - kt * 2) / R, 1e-9);
  EXPECT_NEAR(torque(plant, 3, 0, 2), kt * (vin - kt * 2) / R, 1e-9);  // saturated
}

TEST(ServoLawTest, aDcMotorThatFollowsTorquesIsHeldByItsSupplyAlone) {
  JointPlant plant = nominalPlant(findMechanism("xl330_pendulum")).joints[0];
  plant.servo.followsTorque = true;
  const auto given = [&](double sent, double w) {
    return servoLine(plant, 9, 1, 0, 0.2, w, 1, 1, 0, sent).at(0.2, w);
  };
  const double kt = 0.38042, R = 3.38007, vin = 7.4;
  EXPECT_DOUBLE_EQ(given(0.3, 0), 0.3);
  EXPECT_DOUBLE_EQ(given(0.3, 5), 0.3) << "its own voltage is made up for";
  EXPECT_NEAR(given(0.3, 18), kt * (vin - kt * 18) / R, 1e-9) << "as long as the supply allows";
  EXPECT_NEAR(given(-0.3, -18), -kt * (vin - kt * 18) / R, 1e-9);
  EXPECT_TRUE(std::isnan(dutyOf(plant, 0.1, 0))) << "no error of a position sets its duty";
}

TEST(ServoLawTest, lessSupplyOfADcMotorIsLessVoltageAndNoLimit) {
  const Mechanism pendulum = findMechanism("xl330_pendulum");
  const Effect& supply = *findEffect("supply_voltage");
  const JointPlant plant = plantOf(pendulum, {{&supply, {Site::everywhere, -1, "*"}, 0.9, 0}}).joints[0];
  const double kt = 0.38042, R = 3.38007, vin = 0.9 * 7.4, duty = 400 * 0.00287738 * 0.3;
  EXPECT_NEAR(torque(plant, 0.3, 0, 2), kt * (vin * duty - kt * 2) / R, 1e-9);
  // Against the motion the winding's own voltage comes on top: more than max_torque.
  EXPECT_NEAR(torque(plant, -3, 0, 5), kt * (-vin - kt * 5) / R, 1e-9);
  EXPECT_GT(-torque(plant, -3, 0, 5), plant.maxTorque);
}

TEST(ServoLawTest, lessSupplyOfAPositionServoLowersItsLimits) {
  const Mechanism arm = twoJointArm();
  const Effect& supply = *findEffect("supply_voltage");
  const JointPlant plant = plantOf(arm, {{&supply, {Site::everywhere, -1, "*"}, 0.5, 0}}).joints[0];
  EXPECT_DOUBLE_EQ(torque(plant, 1, 0, 0), 1.5);
  EXPECT_NEAR(torque(plant, 9, 0, 3.325), 0.75, 1e-12);
}

TEST(ServoLawTest, encoderShowsItsError) {
  JointPlant plant;
  plant.offset = 0.1;
  EXPECT_DOUBLE_EQ(measuredAngle(plant, 0.5), 0.4);
  plant.encoderAmplitude = 0.02;
  EXPECT_DOUBLE_EQ(measuredAngle(plant, 0.5), 0.4 + 0.02 * std::sin(0.4));
}

TEST(ServoLawTest, speedsAndTorquesThatAreSentWithThePosition) {
  const JointPlant plant = nominalPlant(twoJointArm()).joints[0];
  const auto sent = [&](double speed, double torque, double share = 1) {
    return servoLine(plant, 0.1, share, 0, 0.02, 0.5, 1, 1, speed, torque).at(0.02, 0.5);
  };
  EXPECT_DOUBLE_EQ(sent(2, 0.3), 20 * 0.08 + 0.4 * (2 - 0.5) + 0.3);
  EXPECT_DOUBLE_EQ(sent(0, 0.3), 20 * 0.08 - 0.4 * 0.5 + 0.3);
  EXPECT_DOUBLE_EQ(sent(2, 0.3, 0.5), 0.5 * (20 * 0.08 + 0.4 * 1.5 + 0.3));
  EXPECT_DOUBLE_EQ(sent(0, 9), 3) << "within the motor's limit";
}

TEST(ServoLawTest, aSupplyThatSagsTakesTorqueAndSpeed) {
  const JointPlant plant = nominalPlant(twoJointArm()).joints[0];
  const auto left = [&](double share, double w) {
    return servoLine(plant, 9, 1, 0, 0, w, 1, share).at(0, w);
  };
  EXPECT_DOUBLE_EQ(left(0.5, 0), 1.5);
  EXPECT_NEAR(left(0.5, 0.95 * 3.5), 0.75, 1e-12) << "half way down from nine tenths of 3.5 rad/s";
  const JointPlant motor = nominalPlant(findMechanism("xl330_pendulum")).joints[0];
  const auto driven = [&](double volts) { return servoLine(motor, 3, 1, volts, 0, 0, 1, 0.5).at(0, 0); };
  EXPECT_NEAR(driven(0), 0.5 * servoLine(motor, 3, 1, 0, 0, 0, 1).at(0, 0), 1e-12);
  EXPECT_NEAR(driven(7.4), servoLine(motor, 3, 1, 7.4, 0, 0, 1).at(0, 0), 1e-12)
      << "a measured one has sagged";
}

TEST(ServoLawTest, aCurrentAndASpeedTakeTheirShareOfTheSupply) {
  JointPlant motor = nominalPlant(twoJointArm()).joints[0];
  EXPECT_TRUE(std::isnan(dutyThatDraws(motor, 1, 0, 0))) << "its constants are not known";
  motor.servo.kt = 0.5;
  motor.servo.R = 2;
  motor.servo.vin = 10;
  EXPECT_NEAR(dutyThatDraws(motor, 3, 4, 0), (3 * 2 + 0.5 * 4) / 10, 1e-12);
  EXPECT_NEAR(dutyThatDraws(motor, 3, 4, 8), 1, 1e-12);
}

TEST(ServoLawTest, dutyIsWhatTheFirmwareMakesOfTheError) {
  JointPlant motor = nominalPlant(findMechanism("xl330_pendulum")).joints[0];
  const double perAngle = 400 * 0.00287738;
  EXPECT_NEAR(dutyOf(motor, 0.5, 0.2), perAngle * 0.3, 1e-12);
  EXPECT_EQ(dutyOf(motor, 3, -3), 1) << "the whole supply";
  motor.deadBand = 0.05;
  EXPECT_EQ(dutyOf(motor, 0.24, 0.2), 0);
  EXPECT_NEAR(dutyOf(motor, 0.5, 0.2), perAngle * 0.25, 1e-12);
  motor.deadBandSteps = true;
  EXPECT_NEAR(dutyOf(motor, 0.5, 0.2), perAngle * 0.3, 1e-12);
  EXPECT_TRUE(std::isnan(dutyOf(nominalPlant(twoJointArm()).joints[0], 0.5, 0.2)))
      << "the law of a position servo has no duty";
}

TEST(ServoLawTest, termsServeForAllStates) {
  JointPlant plant = nominalPlant(findMechanism("xl330_pendulum")).joints[0];
  plant.torqueFactor = 0.5;
  const ServoTerms terms(plant, {0.8, 7, 0.9, 1});
  for (const double x : {-2.0, 0.1, 0.25, 2.0})
    for (const double w : {-3.0, 0.0, 3.0}) {
      const ServoLine line = servoLine(terms, 0.2, x, w), same = servoLine(plant, 0.2, 0.8, 7, x, w, 0.9);
      EXPECT_EQ(line.at(x, w), same.at(x, w));
      EXPECT_EQ(line.regime, same.regime);
    }
  EXPECT_EQ(servoLine(ServoTerms(), 0.2, 0, 1).at(0, 1), 0);
  EXPECT_EQ(servoLine(ServoTerms(plant, {}), 0.2, 0, 1).at(0, 1), 0);
}

}  // namespace
}  // namespace plumbline::gap
