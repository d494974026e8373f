#include "simulation/effects/LeagueEffect.h"

#include <gtest/gtest.h>

#include <cmath>

#include "framework/ConfigurationError.h"
#include "simspark/LeagueRobots.h"
#include "simulation/effects/BodyEffects.h"
#include "simulation/effects/EffectTable.h"
#include "simulation/effects/MotorEffects.h"
#include "simulation/effects/SensorEffects.h"
#include "simulation/league/LocalRobot.h"

namespace plumbline::simulation {
namespace {

EffectSetting setting(const std::string& effect, const std::string& at, double value,
                      const std::string& axis = "") {
  EffectSetting s;
  s.effect = effect;
  s.at = at;
  s.axis = axis;
  s.value = value;
  s.origin = "here";
  return s;
}

/// All that a robot with these effects reads while it swings arms and legs, with another speed in each cycle.
std::vector<double> readingsWith(const std::vector<EffectSetting>& effects) {
  WorldConfig config;
  config.effects = effects;
  LocalRobot robot(simsparkRobot(4), config);
  robot.restart();
  std::vector<double> all;
  for (int cycle = 0; cycle < 80; ++cycle) {
    JointArray speeds{};
    speeds[rElbowRoll] = speeds[lKneePitch] = speeds[headYaw] = 7 * std::cos(0.3 * cycle);
    robot.act(speeds);
    const RobotReadings readings = robot.sense();
    all.insert(all.end(), readings.angle.begin(), readings.angle.end());
    for (const Vec3& v : {readings.gyro, readings.acc})
      for (const double x : v) all.push_back(x);
    for (const auto& foot : {readings.leftFoot, readings.rightFoot, readings.leftToe, readings.rightToe})
      all.push_back(foot ? foot->force.z() : 0);
  }
  return all;
}

/// One that can be set: a place, an axis and a value that is not none.
EffectSetting someSetting(const LeagueEffect& effect) {
  using Site = LeagueEffect::Site;
  const auto place = [&]() -> std::string {
    switch (effect.site) {
      case Site::everywhere:
        return "*";
      case Site::joint:
      case Site::jointOrEverywhere:
        return "LKneePitch";
      case Site::link:
        return "torso";
      case Site::foot:
        return "lFoot";
      case Site::imu:
        return "imu";
      case Site::ground:
        break;
    }
    return "ground";
  };
  // Factors go to 2 and 10 and come from 0; all else is well inside of its range at a fifth of it.
  const double value = effect.upper > 1e3   ? 10
                       : effect.upper > 100 ? 0.5
                                            : effect.lower / 5 + effect.upper / 20;
  return setting(std::string(effect.id), place(), value, effect.axes.empty() ? "" : "y");
}

TEST(LeagueEffect, listsNameThemInTheirOrder) {
  std::string ids;
  for (const LeagueEffect* effect : leagueEffects()) ids += std::string(effect->id) + " ";
  EXPECT_EQ(ids,
            "command_delay command_dropout servo_gain torque_limit speed_limit supply_voltage "
            "coulomb_friction backlash acceleration_limit joint_offset encoder_nonlinearity link_mass "
            "com_offset imu_misalignment gyro_bias imu_delay fsr_gain ground_friction ground_slope "
            "ground_compliance profile_speed command_lag ");
  EXPECT_EQ(findLeagueEffect("no_such"), nullptr);
}

TEST(LeagueEffect, eachChangesWhatARobotReads) {
  const std::vector<double> plain = readingsWith({});
  for (const LeagueEffect* effect : leagueEffects()) {
    SCOPED_TRACE(effect->id);
    const std::vector<EffectSetting> list = {someSetting(*effect)};
    ASSERT_NO_THROW(checkEffects(list));
    EXPECT_NE(readingsWith(list), plain);
  }
}

TEST(LeagueEffect, theOrderInAFileDoesNotMatter) {
  const std::vector<EffectSetting> one = {
      setting("backlash", "HeadYaw", 0.02),   setting("command_dropout", "*", 0.2),
      setting("command_delay", "*", 0.03),    setting("coulomb_friction", "LKneePitch", 2),
      setting("torque_limit", "*", 0.5),      setting("encoder_nonlinearity", "HeadYaw", 0.1),
      setting("joint_offset", "HeadYaw", 0.1)};
  EXPECT_EQ(readingsWith(one), readingsWith({one.rbegin(), one.rend()}));
  EXPECT_DOUBLE_EQ(motorTorque(10, lKneePitch, one), 3) << "friction is taken off the limit as it is then";
}

TEST(LeagueEffect, aCommandThatIsLostIsNotDelayed) {
  MotorEffects motors({setting("command_delay", "HeadYaw", 0.02), setting("command_dropout", "*", 1)}, 0.02,
                      0);
  motors.command(headYaw, 3);
  for (int i = 0; i < 3; ++i) motors.beginCycle();
  EXPECT_EQ(motors.velocity(headYaw), 0);
}

TEST(LeagueEffect, delaysOfOneJointAddUp) {
  MotorEffects motors({setting("command_delay", "HeadYaw", 0.02), setting("command_delay", "*", 0.02)}, 0.02,
                      0);
  motors.command(headYaw, 3);
  motors.command(headPitch, 3);
  for (const auto& [yaw, pitch] : {std::pair{0, 0}, {0, 3}, {3, 3}}) {
    motors.beginCycle();
    EXPECT_EQ(motors.velocity(headYaw), yaw);
    EXPECT_EQ(motors.velocity(headPitch), pitch);
  }
  motors.restart();
  motors.beginCycle();
  EXPECT_EQ(motors.velocity(headYaw), 0);
}

TEST(LeagueEffect, anImuIsLateThenTurnedThenBiased) {
  SensorEffects sensors({setting("gyro_bias", "imu", 0.5, "z"), setting("imu_delay", "imu", 0.03),
                         setting("imu_misalignment", "imu", M_PI / 2, "z")},
                        0.02, 0);
  RobotReadings truth;
  truth.gyro = {1, 0, 0};
  truth.acc = {0, 0, 9.81};
  sensors.read(truth, {}, true);
  truth.gyro = {3, 0, 0};
  RobotReadings readings = sensors.read(truth, {}, true);
  // One cycle and a half late there is only the oldest yet.
  EXPECT_NEAR((readings.gyro - Vec3(0, -1, 0.5)).norm(), 0, 1e-12);
  truth.gyro = {5, 0, 0};
  readings = sensors.read(truth, {}, true);
  EXPECT_NEAR((readings.gyro - Vec3(0, -2, 0.5)).norm(), 0, 1e-12);
  EXPECT_NEAR((readings.acc - Vec3(0, 0, 9.81)).norm(), 0, 1e-12);
  EXPECT_EQ(sensors.read(truth, {}, false).gyro, readings.gyro) << "no time has passed";
  sensors.restart();
  EXPECT_NEAR((sensors.read(truth, {}, true).gyro - Vec3(0, -5, 0.5)).norm(), 0, 1e-12);
}

TEST(LeagueEffect, anEncoderSitsOnTheMotor) {
  SensorEffects sensors(
      {setting("encoder_nonlinearity", "HeadYaw", 0.1), setting("joint_offset", "HeadYaw", 0.2)}, 0.02, 0);
  RobotReadings truth;
  truth.angle[headYaw] = 0.5;
  JointArray slack{};
  slack[headYaw] = 0.25;
  EXPECT_NEAR(sensors.read(truth, slack, true).angle[headYaw], 0.75 - 0.2 + 0.1 * std::sin(0.75), 1e-15);
}

TEST(LeagueEffect, aLinkKeepsAGramAndItsOtherNumbers) {
  const RobotModel plain = simsparkRobot(0);
  const RobotModel changed =
      withEffects(plain, {setting("link_mass", "torso", -5), setting("com_offset", "torso", 0.01, "z"),
                          setting("speed_limit", "HeadYaw", 0.5), setting("supply_voltage", "*", 0.5)});
  EXPECT_EQ(changed.links[0].mass, 1e-3);
  EXPECT_EQ(changed.links[0].com.z(), plain.links[0].com.z() + 0.01);
  const auto speedOf = [&](const RobotModel& model, JointId joint) {
    return model.links[static_cast<std::size_t>(model.linkOfJoint[joint])].maxSpeed;
  };
  EXPECT_EQ(speedOf(changed, headYaw), 0.25 * speedOf(plain, headYaw));
  EXPECT_EQ(speedOf(changed, headPitch), 0.5 * speedOf(plain, headPitch));
}

TEST(LeagueEffect, aSlopeIsAboutAHorizontalAxis) {
  for (const auto& [axis, message] : {std::pair{"z", "axis is z; ground_slope is about x or y"},
                                      {"", "effect is ground_slope, which needs an axis: x or y"}}) {
    try {
      checkEffects({setting("ground_slope", "ground", 0.1, axis)});
      ADD_FAILURE() << axis;
    } catch (const ConfigurationError& error) {
      EXPECT_EQ(error.what(), std::string("here: ") + message);
    }
  }
}

}  // namespace
}  // namespace plumbline::simulation
