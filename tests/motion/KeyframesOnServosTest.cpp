#include <gtest/gtest.h>
#include <unistd.h>

#include <cmath>
#include <filesystem>
#include <fstream>

#include "math/Index.h"
#include "motion/KeyframePlayer.h"
#include "motion/KeyframeReader.h"
#include "robot/HumanoidModel.h"
#include "robot/MechanismFile.h"
#include "servo/BulletRobot.h"

namespace plumbline::motion {
namespace {

/// A robot of tests/data/robots with position servos, which plays keyframe motions.
class ServoRobot {
public:
  explicit ServoRobot(const std::string& name)
      : mechanism(readMechanism("tests/data/robots/" + name + ".json")),
        humanoid(mechanism),
        world_(mechanism) {
    std::filesystem::create_directories(folder_);
  }
  ~ServoRobot() { std::filesystem::remove_all(folder_); }

  KeyframeMotion read(const std::string& text) {
    const std::filesystem::path file = folder_ / "motion.yaml";
    std::ofstream(file) << text;
    return readKeyframeFile(file, humanoid.model(), {});
  }
  std::string errorOf(const std::string& text) {
    try {
      read(text);
    } catch (const KeyframeFileError& error) {
      const std::string what = error.what();
      return what.substr(what.find("motion.yaml"));
    }
    return "";
  }

  JointArray angles() const { return humanoid.toModel(world_.readings().position); }
  double angle(const std::string& joint) const { return world_.readings().position[at(world_.joint(joint))]; }
  /// The torso's height over the ground and how upright it is (1: upright).
  double height() const { return world_.base().pose.translation().z(); }
  double upright() const { return world_.base().pose.linear()(2, 2); }

  void stand(const KeyframeMotion& posture) {
    world_.restart(humanoid.toMechanism(posture.keyframes.front().angles));
    hold(posture.keyframes.front().angles, 1);
  }
  void play(const KeyframeMotion& motion) {
    KeyframePlayer player;
    player.start(motion, angles());
    while (!player.finished()) {
      player.step(1 / mechanism.controlHz, true);
      hold(player.angles(), 1 / mechanism.controlHz);
    }
    hold(player.angles(), 0.5);
  }

  Mechanism mechanism;
  Humanoid humanoid;

private:
  void hold(const JointArray& targets, double seconds) {
    world_.command(humanoid.toMechanism(targets));
    for (double t = 0; t < seconds - 1e-9; t += 1 / mechanism.controlHz) world_.step();
  }

  const std::filesystem::path folder_ =
      std::filesystem::path(testing::TempDir()) / ("keyframes-on-servos-" + std::to_string(getpid()));
  servo::BulletRobot world_;
};

constexpr const char* upright = R"(keyframes:
  - {time: 0, WaistYaw: 0, HeadYaw: 0, HeadPitch: 0, ShoulderPitch: 80, ShoulderRoll: 10, ElbowYaw: 0,
     ElbowRoll: -20, WristYaw: 0, WristPitch: 0, WristRoll: 0, HipYawPitch: 0, HipRoll: 0, HipPitch: -25,
     KneePitch: 50, AnklePitch: -25, AnkleRoll: 0}
)";
constexpr const char* fourLegs = R"(keyframes:
  - {time: 0, FL_hip_roll: 0, FR_hip_roll: 0, RL_hip_roll: 0, RR_hip_roll: 0, FL_hip_pitch: 40, FR_hip_pitch: 40,
     RL_hip_pitch: 40, RR_hip_pitch: 40, FL_knee: -80, FR_knee: -80, RL_knee: -80, RR_knee: -80}
)";

TEST(KeyframesOnServos, aRobotWithAWaistAndArmsOfSevenJointsStandsAndMovesThem) {
  ServoRobot robot("waist_and_arms");
  robot.stand(robot.read(upright));
  const double height = robot.height();
  EXPECT_GT(robot.upright(), 0.99);
  const KeyframeMotion turn = robot.read(
      "rest: stays\nkeyframes:\n"
      "  - {time: 0.6, WaistYaw: 30, LWristYaw: 40, WristPitch: 20, WristRoll: 15, HipPitch: -35, KneePitch: "
      "70, "
      "AnklePitch: -35}\n");
  robot.play(turn);
  EXPECT_GT(robot.upright(), 0.98);
  EXPECT_LT(robot.height(), height - 0.01) << "it bends its knees";
  EXPECT_NEAR(robot.angle("WaistYaw"), 0.524, 0.03);
  EXPECT_NEAR(robot.angle("LWristYaw"), 0.698, 0.03);
  EXPECT_NEAR(robot.angle("RWristYaw"), 0, 0.03);
  EXPECT_NEAR(robot.angle("LWristPitch"), 0.349, 0.05);
  EXPECT_NEAR(robot.angle("RWristRoll"), -0.262, 0.05) << "both sides, as mirror images";

  robot.play(mirrored(turn));
  EXPECT_NEAR(robot.angle("WaistYaw"), -0.524, 0.03);
  EXPECT_NEAR(robot.angle("RWristYaw"), -0.698, 0.03);
  EXPECT_NEAR(robot.angle("RWristPitch"), 0.349, 0.05);
  EXPECT_GT(robot.upright(), 0.98);
}

TEST(KeyframesOnServos, aQuadrupedStandsAndBows) {
  ServoRobot robot("quadruped");
  robot.stand(robot.read(fourLegs));
  const double height = robot.height();
  EXPECT_GT(robot.upright(), 0.99);
  EXPECT_NEAR(height, 2 * 0.15 * std::cos(0.698) + 0.015, 0.01);
  robot.play(
      robot.read("rest: stays\nkeyframes:\n"
                 "  - {time: 0.6, FL_hip_pitch: 60, FR_hip_pitch: 60, FL_knee: -120, FR_knee: -120}\n"));
  EXPECT_LT(robot.height(), height - 0.02) << "in front";
  EXPECT_GT(robot.upright(), 0.9);
  EXPECT_NEAR(robot.angle("FR_knee"), -2.094, 0.06);
  EXPECT_NEAR(robot.angle("RR_knee"), -1.396, 0.06);
}

TEST(KeyframesOnServos, unknownJointsAreNamedWithTheNearest) {
  ServoRobot robot("waist_and_arms");
  EXPECT_EQ(robot.errorOf("keyframes:\n  - {time: 1, WaistYav: 3}\n"),
            "motion.yaml:2: WaistYav: unknown joint; did you mean \"WaistYaw\"?");
  EXPECT_EQ(robot.errorOf("keyframes:\n  - {time: 1, WristPich: 3}\n"),
            "motion.yaml:2: WristPich: unknown joint; did you mean \"WristPitch\"?");
  EXPECT_EQ(
      robot.errorOf("keyframes:\n  - {time: 1, WaistYaw: 90}\n"),
      "motion.yaml:2: WaistYaw: 90 degrees is out of the limits -68.7549 to 68.7549 of WaistYaw in robot "
      "waist_and_arms");
  try {
    robot.angle("WaistYav");
    FAIL();
  } catch (const std::invalid_argument& error) {
    EXPECT_STREQ(error.what(), "robot waist_and_arms has no joint WaistYav; did you mean \"WaistYaw\"?");
  }
}

}  // namespace
}  // namespace plumbline::motion
