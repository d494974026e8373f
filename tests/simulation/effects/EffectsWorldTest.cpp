#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <functional>

#include "framework/ConfigurationError.h"
#include "simspark/LeagueRobots.h"
#include "simulation/effects/EffectTable.h"
#include "simulation/effects/MotorEffects.h"
#include "simulation/league/LocalRobot.h"

namespace plumbline::simulation {
namespace {

std::vector<EffectSetting> effects(const std::string& lines) {
  const std::string path = (std::filesystem::path(testing::TempDir()) / "effects.yaml").string();
  std::ofstream(path) << "effects:\n" << lines;
  return readEffects(path);
}

std::string refusal(const std::string& line) {
  try {
    checkEffects(effects("  - " + line + "\n"));
  } catch (const ConfigurationError& error) {
    const std::string what = error.what();
    return what.substr(what.find("effects.yaml"));
  }
  return "";
}

/// A robot that stands for a second with these effects, then swings its right arm and head.
RobotReadings standing(const std::vector<EffectSetting>& list,
                       const std::function<void(LocalRobot&)>& look = {}) {
  WorldConfig config;
  config.effects = list;
  LocalRobot robot(simsparkRobot(0), config);
  robot.restart();
  JointArray speeds{};
  for (int i = 0; i < 50; ++i) robot.act(speeds);
  for (int i = 0; i < 10; ++i) {
    speeds[rElbowRoll] = 1;
    speeds[headYaw] = i < 5 ? 1 : -1;
    robot.act(speeds);
    if (look) look(robot);
  }
  return robot.sense();
}

/// What reading an answer of that text says; empty: nothing.
std::string answerRefusal(const std::string& text, std::vector<EffectSetting>* read = nullptr) {
  const std::string path = (std::filesystem::path(testing::TempDir()) / "effects_answer.json").string();
  std::ofstream(path) << text;
  try {
    const std::vector<EffectSetting> list = readEffects(path);
    if (read) *read = list;
  } catch (const ConfigurationError& error) {
    const std::string what = error.what();
    return what.substr(what.find("effects_answer.json"));
  }
  return "";
}

TEST(EffectFile, anAnswersEffectsAreReadAsTheyStand) {
  std::vector<EffectSetting> list;
  EXPECT_EQ(answerRefusal(R"({"verdict": "effect", "gap": {"closed": 0.9}, "effects": [
    {"effect": "backlash", "at": "LKneePitch", "axis": null, "value": 0.03, "probability": 0.9, "variant": "v"},
    {"effect": "com_offset", "at": "torso", "axis": "z", "value": 0.01}]})",
                          &list),
            "");
  ASSERT_EQ(list.size(), 2U);
  EXPECT_EQ(list[0].effect, "backlash");
  EXPECT_EQ(list[0].axis, "");
  EXPECT_EQ(list[0].variant, "v");
  EXPECT_EQ(list[1].axis, "z");
  EXPECT_EQ(list[1].value, 0.01);
  EXPECT_EQ(answerRefusal(R"({"verdict": "none", "effects": []})", &list), "");
  EXPECT_TRUE(list.empty());
  EXPECT_EQ(
      answerRefusal(R"({"verdict": "unknown", "effects": []})"),
      "effects_answer.json: the verdict is unknown, its effects are not the cause; bin/gap apply writes the "
      "nearest with --anyway, the values of all joints with --further");
  EXPECT_EQ(answerRefusal("{\"a\": 1}"),
            "effects_answer.json: is no answer of bin/gap diagnose: its verdict is neither none, effect nor "
            "unknown");
  EXPECT_EQ(
      answerRefusal(R"({"verdict": "effect", "effects": [{"effect": "backlash", "at": "LKneePitch"}]})"),
      "effects_answer.json: effects[0]: effect needs effect, at and value");
}

TEST(EffectTable, RefusesInOneLine) {
  EXPECT_TRUE(
      refusal("{effect: thermal_derating, at: LKneePitch, value: 0.1}")
          .starts_with("effects.yaml:2: effects[0].effect is \"thermal_derating\", which the league's "
                       "robots cannot have; there is command_delay, "));
  EXPECT_EQ(refusal("{effect: backlash, at: LKnee, value: 0.1}"),
            "effects.yaml:2: effects[0].at is \"LKnee\"; backlash sits at a joint such as LKneePitch");
  EXPECT_EQ(
      refusal("{effect: backlash, at: LKneePich, value: 0.1}"),
      "effects.yaml:2: effects[0].at is \"LKneePich\"; backlash sits at a joint such as LKneePitch; did you "
      "mean \"LKneePitch\"?");
  EXPECT_EQ(refusal("{effect: backlash, at: LKneePitch, value: 3}"),
            "effects.yaml:2: effects[0].value is 3; backlash goes from 0 to 0.5");
  EXPECT_EQ(refusal("{effect: gyro_bias, at: imu, value: 0.1}"),
            "effects.yaml:2: effects[0].effect is gyro_bias, which needs an axis: x, y or z");
  EXPECT_EQ(refusal("{effect: link_mass, at: LThigh, value: 0.1}"), "");
}

TEST(EffectsWorld, NoEffectsNoChange) {
  const RobotReadings plain = standing({}),
                      zero = standing(effects("  - {effect: command_delay, at: \"*\", value: 0}\n"));
  EXPECT_EQ(plain.angle, zero.angle);
  EXPECT_EQ(plain.gyro, zero.gyro);
}

TEST(EffectsWorld, SensorsLie) {
  const RobotReadings plain = standing({});
  const RobotReadings changed =
      standing(effects("  - {effect: joint_offset, at: HeadPitch, value: 0.05}\n"
                       "  - {effect: gyro_bias, at: imu, axis: y, value: 0.3}\n"
                       "  - {effect: fsr_gain, at: lFoot, value: 0.5}\n"));
  EXPECT_NEAR(changed.angle[headPitch], plain.angle[headPitch] - 0.05, 1e-12);
  EXPECT_NEAR(changed.gyro.y() - plain.gyro.y(), 0.3, 1e-12);
  ASSERT_TRUE(plain.leftFoot && changed.leftFoot && changed.rightFoot);
  EXPECT_NEAR(changed.leftFoot->force.z(), 0.5 * plain.leftFoot->force.z(), 1e-9);
  EXPECT_NEAR(changed.rightFoot->force.z(), plain.rightFoot->force.z(), 1e-9);
}

TEST(EffectsWorld, AGroundThatSlopesShowsInTheAccelerometer) {
  const double slope = 0.05;
  WorldConfig config;
  config.effects = effects("  - {effect: ground_slope, at: ground, axis: y, value: 0.05}\n");
  LocalRobot robot(simsparkRobot(0), config);
  robot.restart();
  for (int i = 0; i < 100; ++i) robot.act({});
  // Turned about y by a positive angle the ground falls towards +x; what holds the robot leans back.
  EXPECT_NEAR(robot.sense().acc.x(), -9.81 * std::sin(slope), 0.1);
  EXPECT_NEAR(robot.sense().acc.norm(), 9.81, 0.1);
}

TEST(EffectsWorld, AHeavyTorsoWeighsMore) {
  const auto weight = [](const RobotReadings& r) { return r.leftFoot->force.z() + r.rightFoot->force.z(); };
  const double plain = weight(standing({}));
  const double heavy = weight(standing(effects("  - {effect: link_mass, at: torso, value: 1}\n")));
  EXPECT_NEAR(heavy - plain, 9.81, 2);
}

TEST(MotorEffects, aProfileKeepsItsSpeed) {
  MotorEffects motors(effects("  - {effect: profile_speed, at: LKneePitch, value: 1.5}\n"), 0.02, 1);
  EXPECT_TRUE(motors.touches(lKneePitch));
  EXPECT_FALSE(motors.touches(rKneePitch));
  for (const auto& [asked, done] : {std::pair{4.0, 1.5}, {-4.0, -1.5}, {0.7, 0.7}}) {
    motors.command(lKneePitch, asked);
    motors.beginCycle();
    EXPECT_EQ(motors.velocity(lKneePitch), done);
  }
}

TEST(MotorEffects, ALagComesNearExponentially) {
  MotorEffects motors(effects("  - {effect: command_lag, at: HeadYaw, value: 0.03}\n"
                              "  - {effect: command_lag, at: HeadYaw, value: 0.01}\n"),
                      0.02, 0);
  motors.command(headYaw, 2);
  double way = 0;
  for (int i = 1; i <= 4; ++i) {
    motors.beginCycle();
    way += 0.02 * motors.velocity(headYaw);
    EXPECT_NEAR(way, 2 * (0.02 * i - 0.04 * (1 - std::exp(-0.5 * i))), 1e-12);
  }
}

TEST(MotorEffects, DelayCountsPartsOfACycle) {
  MotorEffects motors(effects("  - {effect: command_delay, at: HeadYaw, value: 0.03}\n"), 0.02, 0);
  EXPECT_TRUE(motors.touches(headYaw));
  EXPECT_FALSE(motors.touches(headPitch));
  motors.command(headYaw, 2);
  std::vector<double> speeds;
  for (int i = 0; i < 4; ++i) {
    motors.beginCycle();
    speeds.push_back(motors.velocity(headYaw));
  }
  ASSERT_EQ(speeds.size(), 4U);
  EXPECT_DOUBLE_EQ(speeds[0], 0);
  EXPECT_NEAR(speeds[1], 1, 1e-12);
  EXPECT_NEAR(speeds[2], 2, 1e-12);
  EXPECT_NEAR(speeds[3], 2, 1e-12);
}

TEST(MotorEffects, PlayIsCrossedBeforeTheLinkMoves) {
  MotorEffects motors(effects("  - {effect: backlash, at: HeadYaw, value: 0.05}\n"), 0.02, 0);
  const auto travel = [&](double speed, int cycles) {
    double way = 0;
    motors.command(headYaw, speed);
    for (int i = 0; i < cycles; ++i) {
      motors.beginCycle();
      way += 0.02 * motors.velocity(headYaw);
    }
    return way;
  };
  EXPECT_NEAR(travel(1, 10), 0.2 - 0.025, 1e-12);
  EXPECT_NEAR(motors.slack(headYaw), 0.025, 1e-12);
  EXPECT_NEAR(travel(-1, 10), -0.2 + 0.05, 1e-12);
  EXPECT_NEAR(motors.slack(headYaw), -0.025, 1e-12);
}

TEST(MotorEffects, LostCyclesHoldTheLastSpeed) {
  MotorEffects motors(effects("  - {effect: command_dropout, at: \"*\", value: 0.3}\n"), 0.02, 1);
  int kept = 0;
  double last = 0;
  constexpr int cycles = 2000;
  for (int i = 1; i <= cycles; ++i) {
    motors.command(headYaw, i);
    motors.beginCycle();
    const double speed = motors.velocity(headYaw);
    if (speed != i) {
      EXPECT_EQ(speed, last);
      ++kept;
    }
    last = speed;
  }
  EXPECT_NEAR(kept, 0.3 * cycles, 4 * std::sqrt(0.3 * 0.7 * cycles));
}

TEST(MotorEffects, AccelerationAndGain) {
  MotorEffects motors(effects("  - {effect: servo_gain, at: HeadYaw, value: 0.5}\n"
                              "  - {effect: acceleration_limit, at: HeadYaw, value: 10}\n"),
                      0.02, 0);
  motors.command(headYaw, 1);
  std::vector<double> speeds;
  for (int i = 0; i < 4; ++i) {
    motors.beginCycle();
    speeds.push_back(motors.velocity(headYaw));
  }
  EXPECT_NEAR(speeds[0], 0.2, 1e-12);
  EXPECT_NEAR(speeds[1], 0.4, 1e-12);
  EXPECT_NEAR(speeds[2], 0.5, 1e-12);
  EXPECT_NEAR(speeds[3], 0.5, 1e-12);
}

}  // namespace
}  // namespace plumbline::simulation
