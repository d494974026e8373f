#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "gap/TwoJointArm.h"
#include "gap/effects/Effects.h"
#include "gap/record/EngineRecording.h"
#include "gap/record/ExcitationFile.h"
#include "gap/record/SimsparkRecording.h"
#include "gap/replay/Replay.h"
#include "gap/replay/TrialOf.h"
#include "gap/run/RunCheck.h"
#include "robot/MechanismFile.h"
#include "robot/RobotModel.h"
#include "simulation/ServerFixture.h"
#include "support/Thrown.h"

namespace plumbline::gap {
namespace {

double rms(const std::vector<double>& a, const std::vector<double>& b) {
  double sum = 0;
  for (std::size_t i = 0; i < a.size(); ++i) sum += (a[i] - b[i]) * (a[i] - b[i]);
  return std::sqrt(sum / static_cast<double>(a.size()));
}

Excitation swing(const Mechanism& robot) {
  Excitation program;
  program.name = program.about = "swing";
  program.posture.assign(robot.joints.size(), 0.2);
  Segment wave;
  wave.kind = Segment::Kind::sine;
  wave.start = 0.4;
  wave.duration = 3;
  wave.fromHz = 0.8;
  wave.joints = {{0, 0.3}, {1, 0.4}};
  program.segments = {wave};
  program.duration = 4;
  return program;
}

/// The arm's swing without noise, in the own dynamics and in Bullet.
struct Swings {
  gap::Run own, bullet;
};
Swings swings(const Explanation& effects = {}) {
  const Mechanism arm = twoJointArm();
  SimulatedRecordingOptions options;
  options.noisy = false;
  options.effects = effects;
  return {recordSimulated(arm, swing(arm), options), recordInEngine("bullet", arm, swing(arm), options)};
}

TEST(Simspark, cyclesAreCountedThoughTheClockIsCoarse) {
  EXPECT_EQ(cyclesBetween(5, 5), 0u) << "it stood still";
  EXPECT_EQ(cyclesBetween(5, 5.02), 1u);
  // The league's server after six hours: single precision, and hundredths are printed.
  EXPECT_EQ(cyclesBetween(21360.12, 21360.13), 1u);
  EXPECT_EQ(cyclesBetween(21360.12, 21360.15), 1u);
  EXPECT_EQ(cyclesBetween(5, 5.04), 2u) << "one was lost";
  EXPECT_EQ(cyclesBetween(5, 5.2), 10u);
  EXPECT_EQ(cyclesBetween(5, 4), 0u) << "back in time";
}

TEST(EngineRecording, AgreesWithTheOwnDynamicsOnAFixedArm) {
  const auto [own, bullet] = swings();
  for (const char* joint : {"shoulder", "elbow"}) {
    const std::string channel = channelName(ChannelKind::position, joint);
    EXPECT_LT(rms(*own.find(channel), *bullet.find(channel)), 1e-3) << joint;
  }
  EXPECT_EQ(own.t, bullet.t);
}

TEST(EngineRecording, IsNotAheadOfTheOwnDynamics) {
  const auto [own, bullet] = swings();
  for (const char* joint : {"shoulder", "elbow"}) {
    const std::string channel = channelName(ChannelKind::position, joint);
    const std::vector<double>&x = *own.find(channel), &y = *bullet.find(channel);
    double product = 0, squares = 0;
    for (std::size_t k = 1; k + 1 < x.size(); ++k) {
      const double speed = (x[k + 1] - x[k - 1]) / (own.t[k + 1] - own.t[k - 1]);
      product += (y[k] - x[k]) * speed, squares += speed * speed;
    }
    EXPECT_LT(std::abs(product / squares), 2e-5) << joint << ", in seconds; half a step is 2.5e-4";
  }
}

TEST(EngineRecording, EveryEffectShowsAsInTheOwnDynamics) {
  const gap::Run nominal = swings().bullet;
  struct Size {
    const char* effect;
    const char* at;
    double value;
  };
  for (const Size& size : {Size{"servo_gain", "elbow", 0.6},
                           Size{"servo_damping", "elbow", 2},
                           Size{"torque_limit", "*", 0.15},
                           Size{"speed_limit", "elbow", 0.25},
                           Size{"command_delay", "elbow", 0.0123},
                           Size{"coulomb_friction", "elbow", 0.2},
                           Size{"viscous_friction", "elbow", 0.3},
                           Size{"stribeck_friction", "elbow", 0.25},
                           Size{"load_friction", "shoulder", 0.3},
                           Size{"backlash", "elbow", 0.1},
                           Size{"joint_compliance", "elbow", 0.1},
                           Size{"acceleration_limit", "elbow", 8},
                           Size{"dead_band", "elbow", 0.02},
                           Size{"supply_voltage", "*", 0.2},
                           Size{"bias_force", "elbow", 0.2},
                           Size{"thermal_derating", "shoulder", 4},
                           Size{"rotor_inertia", "elbow", 0.03},
                           Size{"joint_offset", "shoulder", 0.05},
                           Size{"encoder_nonlinearity", "elbow", 0.1},
                           Size{"link_mass", "lower", 0.3},
                           Size{"link_length", "upper", 1.2},
                           Size{"asymmetric_friction", "elbow", 0.3},
                           Size{"load_stribeck_friction", "shoulder", 0.5},
                           Size{"link_load_friction", "shoulder", 0.3},
                           Size{"quadratic_load_friction", "shoulder", 1.3},
                           Size{"profile_speed", "elbow", 1},
                           Size{"command_lag", "elbow", 0.05},
                           Size{"payload", "lower", 0.1}}) {
    const Effect* effect = findEffect(size.effect);
    for (int variant = 0; variant < effect->numVariants(); ++variant) {
      Cause c = causeOfArm(size.effect, size.at, size.value);
      c.variant = variant;
      const auto [own, bullet] = swings({c});
      double change = 0, apart = 0;
      for (const char* joint : {"shoulder", "elbow"}) {
        const std::string channel = channelName(ChannelKind::position, joint);
        change += rms(*nominal.find(channel), *bullet.find(channel));
        apart += rms(*own.find(channel), *bullet.find(channel));
      }
      EXPECT_GT(change, 1.5e-3) << describe(c) << " " << variant;
      // With its encoder behind such a gear the joint has a limit cycle, in no two engines at the same time.
      if (variant == 1 && (effect->id == "backlash" || effect->id == "joint_compliance")) continue;
      EXPECT_LT(apart, 0.05 * change + 6e-4) << describe(c) << " " << variant;
    }
  }
}

TEST(EngineRecording, ASupplySagsUnderTheLoadOfAllMotors) {
  // Where torque limits matter; the model's whole torque is seldom drawn.
  const Explanation weak = {causeOfArm("torque_limit", "*", 0.2)};
  Explanation sagging = weak;
  sagging.push_back(causeOfArm("supply_sag", "*", 3));
  const auto [own, bullet] = swings(sagging);
  const gap::Run stiff = swings(weak).bullet;
  const std::string channel = channelName(ChannelKind::position, "shoulder");
  const double change = rms(*stiff.find(channel), *bullet.find(channel));
  EXPECT_GT(change, 1.5e-3);
  EXPECT_LT(rms(*own.find(channel), *bullet.find(channel)), 0.05 * change + 6e-4);
}

TEST(EngineRecording, TwoForcesAtOnceAreOneTooMany) {
  const Mechanism nao = findMechanism("nao_v5");
  SimulatedRecordingOptions options;
  const Effect* force = findEffect("external_force");
  options.effects = {{force, findPlace(*force, nao, "torso", "x"), 3, 0},
                     {force, findPlace(*force, nao, "Head", "y"), 2, 0}};
  EXPECT_EQ(thrownBy([&] { recordInEngine("bullet", nao, findExcitation("stand_sway", nao), options); }),
            "engine bullet has one external_force at a time; --engine own has several");
}

TEST(EngineRecording, ANaoStandsAndFeelsItsWeight) {
  const Mechanism nao = findMechanism("nao_v5");
  Excitation program = findExcitation("stand_sway", nao);
  program.duration = 2.5;
  SimulatedRecordingOptions options;
  options.truth = true;
  const gap::Run run = recordInEngine("bullet", nao, program, options);
  double weight = 0;
  for (const auto& [name, values] : run.channels)
    if (name.starts_with("fsr.")) weight += values.back();
  double mass = 0;
  for (const auto& link : nao.links) mass += link.mass;
  EXPECT_NEAR(weight, 9.81 * mass, 0.1 * 9.81 * mass);
  EXPECT_GT(run.find("truth.z")->back(), 0.2);
  EXPECT_NEAR(run.find("acc.z")->back(), 9.81, 0.5);
}

TEST(SimsparkRecording, PlaysAProgramOnARobotOfAServer) {
  const Mechanism robot = findMechanism("simspark_type1");
  test::RunningServer server(test::inStep());
  SimsparkRecordingOptions options;
  options.port = server.agentPort();
  options.type = 1;
  const SimsparkRecording recording = recordSimspark(robot, findExcitation("stand_squat", robot), options);
  EXPECT_EQ(recording.lostCycles, 0u);
  EXPECT_FALSE(recording.fell);
  gap::Run run = recording.run;
  EXPECT_EQ(run.robot, "simspark_type1");
  EXPECT_TRUE(run.freeBase);
  ASSERT_GT(run.size(), 700u);
  for (std::size_t k = 1; k < run.size(); ++k) ASSERT_NEAR(run.t[k] - run.t[k - 1], 0.02, 1e-9);
  // The knees follow, late by the speed loop and the server's own cycles.
  const auto &command = *run.find("cmd.LKneePitch"), &position = *run.find("pos.LKneePitch");
  EXPECT_NEAR(position[10], command[10], 0.02);
  double most = 0, off = 0;
  for (std::size_t k = 0; k < run.size(); ++k) {
    most = std::max(most, position[k]);
    if (k >= 5) off = std::max(off, std::abs(position[k] - command[k - 5]));
  }
  EXPECT_GT(most, 1.3);
  EXPECT_LT(off, 0.05);
  std::vector<RunWarning> warnings;
  checkRun(run, robot, warnings);
  for (const RunWarning& warning : warnings) EXPECT_FALSE(warning.leftOut) << warning.line("run");
  // Joints that carry little go as the robot file's servo law says, a cycle late as the run says.
  const Trial trial = trialOf(run, robot);
  const Prediction played = replay(nominalPlant(robot), trial);
  const auto shoulder = std::ranges::find(trial.signals, "pos.LShoulderPitch", &Signal::name);
  ASSERT_NE(shoulder, trial.signals.end());
  const auto s = static_cast<std::size_t>(shoulder - trial.signals.begin());
  EXPECT_LT(rms(shoulder->values, played.values[s]), 1e-3);
}

TEST(SimsparkRecording, SaysWhyItCannot) {
  const Mechanism robot = findMechanism("simspark_type0");
  SimsparkRecordingOptions options;
  options.port = 1;
  EXPECT_EQ(
      thrownBy([&] { recordSimspark(robot, findExcitation("stand_squat", robot), options); }),
      "cannot connect to 127.0.0.1:1: Connection refused; start bin/simulator or the league's server first");
  EXPECT_EQ(thrownBy([&] { recordSimspark(robot, findExcitation("hang_small", robot), options); }),
            "hang_small is for a robot with a fixed base; SimSpark's robots stand: use a program on the "
            "feet, such as stand_squat");
}

}  // namespace
}  // namespace plumbline::gap
