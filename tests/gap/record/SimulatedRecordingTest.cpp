#include "gap/record/SimulatedRecording.h"

#include <gtest/gtest.h>

#include <cmath>
#include <stdexcept>

#include "gap/TwoJointArm.h"
#include "gap/record/Secret.h"

namespace plumbline::gap {
namespace {

/// The second joint goes slowly to and fro.
Excitation triangle(const Mechanism& robot) {
  Excitation program;
  program.name = "triangle";
  program.about = "slow triangle";
  program.posture.assign(robot.joints.size(), 0);
  Segment wave;
  wave.kind = Segment::Kind::triangle;
  wave.start = 0.4;
  wave.duration = 4;
  wave.cycles = 2;
  wave.joints = {{1, 0.3}};
  program.segments = {wave};
  program.duration = 5;
  return program;
}

double rmsDifference(const std::vector<double>& a, const std::vector<double>& b) {
  double sum = 0;
  for (std::size_t i = 0; i < a.size(); ++i) sum += (a[i] - b[i]) * (a[i] - b[i]);
  return std::sqrt(sum / static_cast<double>(a.size()));
}

TEST(SimulatedRecording, SameSeedSameNumbersAndNoiseOfTheSensors) {
  const Mechanism robot = twoJointArm();
  const Excitation program = triangle(robot);
  SimulatedRecordingOptions options;
  const auto one = recordSimulated(robot, program, options), same = recordSimulated(robot, program, options);
  const std::string channel = channelName(ChannelKind::position, robot.joints[1].name);
  EXPECT_EQ(one.channels, same.channels);
  EXPECT_EQ(one.motion, "slow triangle");
  EXPECT_FALSE(one.freeBase);
  options.noisy = false;
  const auto clean = recordSimulated(robot, program, options);
  options.noisy = true;
  options.seed = 2;
  const auto other = recordSimulated(robot, program, options);
  const SensorNoise noise;
  const double expected = std::hypot(noise.encoder, noise.encoderStep / std::sqrt(12.0));
  EXPECT_NEAR(rmsDifference(*one.find(channel), *clean.find(channel)), expected, 0.15 * expected);
  EXPECT_GT(rmsDifference(*one.find(channel), *other.find(channel)), 0.2 * expected);
  EXPECT_EQ(*one.find(channelName(ChannelKind::command, robot.joints[1].name)),
            *other.find(channelName(ChannelKind::command, robot.joints[1].name)));
}

TEST(SimulatedRecording, AnOffsetShowsAsOne) {
  const Mechanism robot = twoJointArm();
  SimulatedRecordingOptions options;
  options.noisy = false;
  const auto nominal = recordSimulated(robot, triangle(robot), options);
  const Effect* effect = findEffect("bias_force");
  options.effects = {{effect, findPlace(*effect, robot, robot.joints[1].name, ""), 0.1, 0}};
  const auto pushed = recordSimulated(robot, triangle(robot), options);
  const std::string channel = channelName(ChannelKind::position, robot.joints[1].name);
  // At rest the servo and gravity balance the push: more than nothing, less than the servo alone would give.
  const double moved = pushed.find(channel)->front() - nominal.find(channel)->front();
  EXPECT_GT(moved, 0.2 * 0.1 / robot.joints[1].servo.kp);
  EXPECT_LT(moved, 1.2 * 0.1 / robot.joints[1].servo.kp);
}

TEST(SimulatedRecording, ARobotWithoutFeetDoesNotStand) {
  const Mechanism robot = twoJointArm();
  Excitation program = triangle(robot);
  program.freeBase = true;
  EXPECT_THROW(recordSimulated(robot, program), std::invalid_argument);
}

TEST(Secret, IsDrawnBySeedAndSeen) {
  const Mechanism robot = twoJointArm();
  const std::vector<Excitation> programs{triangle(robot)};
  const Cause secret = drawSecret(robot, programs, 3), same = drawSecret(robot, programs, 3);
  EXPECT_TRUE(secret.sameKind(same));
  EXPECT_EQ(secret.value, same.value);
  int different = 0;
  for (std::uint64_t seed = 4; seed < 10; ++seed)
    different += !drawSecret(robot, programs, seed).sameKind(secret);
  EXPECT_GE(different, 3);
}

TEST(Secret, SealsAndOpens) {
  const std::string text = "effects:\n  - {effect: backlash}\n";
  const std::string sealed = seal(text, 7);
  EXPECT_EQ(unseal(sealed), text);
  EXPECT_EQ(sealed.find("backlash"), std::string::npos);
  EXPECT_NE(sealed, seal(text, 8));
  std::string broken = sealed;
  broken.back() = broken.back() == '0' ? '1' : '0';
  for (const std::string& bad : {std::string(), std::string("xyz"), broken, sealed.substr(0, 15)})
    EXPECT_THROW(unseal(bad), std::invalid_argument) << bad;
}

}  // namespace
}  // namespace plumbline::gap
