#include "training/MotionDriver.h"

#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <stdexcept>

#include "framework/ConfigFolder.h"
#include "support/ScratchFolder.h"
#include "support/Thrown.h"
#include "training/MotionTrial.h"

namespace plumbline::training {
namespace {

/// A robot that does what it is told, and whose torso is turned by hand.
class Puppet : public MotionDriver {
public:
  explicit Puppet(int type) : MotionDriver(type) { sensed.angle = stand; }
  const simulation::RobotReadings& readings() const override { return sensed; }
  Pose3 torsoPose() const override { return torso; }
  Vec3 feltUp() const override { return felt ? *felt : up(); }
  void restart() { forget(); }

  simulation::RobotReadings sensed;
  Pose3 torso = translation(0, 0, 0.4);
  std::optional<Vec3> felt;
  int moves = 0;

private:
  void move(const JointArray& targets) override {
    sensed.angle = targets;
    ++moves;
  }
};

TEST(MotionDriver, liesAfterFiveTiltedCyclesAndIsStillAfterThree) {
  Puppet robot(0);
  robot.torso = rotationX(1.1);
  for (int i = 0; i < 4; ++i) robot.step(robot.stand);
  EXPECT_FALSE(robot.lying());
  robot.step(robot.stand);
  EXPECT_TRUE(robot.lying());
  EXPECT_NEAR(robot.tilt(), 1.1, 1e-9);
  EXPECT_TRUE(robot.still());
  robot.sensed.gyro = Vec3(0, 0.5, 0);
  robot.step(robot.stand);
  EXPECT_FALSE(robot.still());
  robot.restart();
  EXPECT_FALSE(robot.lying()) << "what was before is forgotten";
}

TEST(MotionDriver, playsAMotionToItsEndOrToAFall) {
  Puppet robot(0);
  const motion::KeyframeMotion& motion = robot.motion("standUpFront");
  EXPECT_TRUE(robot.play(motion));
  EXPECT_NEAR(robot.elapsed, MotionDriver::dt * robot.moves, 1e-9);
  EXPECT_GT(robot.moves, 50);
  robot.moves = 0;
  robot.torso = rotationY(1.5);
  EXPECT_FALSE(robot.play(motion, true));
  EXPECT_EQ(robot.moves, 5);
}

TEST(MotionDriver, theWalkLeansAgainstTheLeanThatItFeels) {
  Puppet upright(0), leaning(0);
  leaning.felt = rotationY(0.15).linear().transpose() * Vec3::UnitZ();
  double difference = 0;
  for (int i = 0; i < 40; ++i) {
    upright.walkStep(Vec2(0.2, 0), 0);
    leaning.walkStep(Vec2(0.2, 0), 0);
    difference += std::abs(upright.sensed.angle[lHipPitch] - leaning.sensed.angle[lHipPitch]);
  }
  EXPECT_GT(difference, 0.1);
}

TEST(MotionDriver, choosesTheStandUpByHowItLies) {
  Puppet robot(0);
  robot.torso = rotationY(1.5);
  EXPECT_EQ(robot.nextStandUp().name, "standUpFrontFast");
  EXPECT_EQ(robot.nextStandUp(true).name, "standUpFront") << "the other one";
  robot.torso = rotationY(-1.5);
  EXPECT_EQ(robot.nextStandUp().name, "standUpBackFast");
  robot.torso = rotationX(1.5);
  EXPECT_EQ(robot.nextStandUp().name, "rollOver");
}

TEST(MotionDriver, namesAMotionThatIsMissing) {
  const MotionTrial trial(0);
  try {
    trial.motion("somersault");
    FAIL() << "there is none";
  } catch (const std::out_of_range& error) {
    EXPECT_STREQ(error.what(), "no motion somersault");
  }
}

TEST(MotionDriver, aSeedRepeatsItsNumbers) {
  MotionTrial one(0), other(0);
  one.seed(7);
  other.seed(7);
  for (int i = 0; i < 100; ++i) {
    const double drawn = one.random(-2, 3);
    EXPECT_GE(drawn, -2);
    EXPECT_LE(drawn, 3);
    EXPECT_EQ(drawn, other.random(-2, 3));
  }
}

// A file that says nothing of a stand-up asks for the one that there usually is.
TEST(MotionDriver, aStandUpThatThereIsNotIsNamedWhereItIsAskedFor) {
  namespace fs = std::filesystem;
  const test::ScratchFolder folder;
  for (const auto& entry : fs::directory_iterator("config"))
    if (entry.path().filename() != "motions" && entry.path().filename() != "MotionSelector.yaml")
      fs::create_symlink(fs::absolute(entry.path()), fs::path(folder.path()) / entry.path().filename());
  fs::copy("config/motions", folder / "motions");
  fs::remove(folder / "motions/standUpBack.yaml");
  useConfigFolder(folder.path());
  const auto errorWith = [&](const std::string& text) {
    folder.write("MotionSelector.yaml", text);
    return thrownBy([] { const Puppet robot(0); });
  };
  const std::string missing = "there is no motion standUpBack in motions/";
  const std::string unsaid = errorWith(""), other = errorWith("standUp: {front: standUpFront}\n"),
                    said = errorWith("standUp: {back: standUpBack}\n");
  useConfigFolder("config");
  EXPECT_TRUE(unsaid.starts_with("MotionSelector.standUp.back " + missing)) << unsaid;
  EXPECT_TRUE(other.starts_with("MotionSelector.standUp.back " + missing)) << other;
  EXPECT_NE(said.find("MotionSelector.yaml:1: standUp.back " + missing), std::string::npos) << said;
}

}  // namespace
}  // namespace plumbline::training
