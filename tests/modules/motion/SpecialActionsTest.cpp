#include "modules/motion/SpecialActions.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>

#include "ModuleUnderTest.h"
#include "framework/ConfigurationError.h"
#include "simspark/LeagueRobots.h"

namespace plumbline {
namespace {

namespace fs = std::filesystem;

struct Actions : public SpecialActions {
  using SpecialActions::theFrameInfo;
  using SpecialActions::theJointData;
  using SpecialActions::theMotionSelection;
  using SpecialActions::theRobotDescription;
  using SpecialActions::theSensorData;
};

class SpecialActionsTest : public testing::Test {
protected:
  SpecialActionsTest() : directory(fs::path(testing::TempDir()) / "SpecialActionsTest") {
    fs::remove_all(directory);
    fs::create_directories(directory / "motions");
    write("wave", "keyframes:\n  - {time: 0.1, LShoulderPitch: -57.29577951308232, settle: 0.5}\n");
    description.model = simsparkRobot(0);
    description.name = description.model.name;
  }
  ~SpecialActionsTest() override { fs::remove_all(directory); }
  void write(const std::string& name, const std::string& text) {
    std::ofstream(directory / "motions" / (name + ".yaml")) << text;
  }
  void make() {
    actions = std::make_unique<ModuleUnderTest<Actions>>("SpecialActions",
                                                         std::vector<std::string>{directory.string()});
    Actions& module = *actions->operator->();
    module.theFrameInfo = &frame;
    module.theJointData = &joints;
    module.theMotionSelection = &selection;
    module.theRobotDescription = &description;
    module.theSensorData = &sensors;
  }
  void cycle() {
    (*actions)->update(&output);
    selection.started = false;
  }

  fs::path directory;
  std::unique_ptr<ModuleUnderTest<Actions>> actions;
  FrameInfo frame;
  JointData joints;
  MotionSelection selection;
  RobotDescription description;
  SensorData sensors;
  SpecialActionsOutput output;
};

TEST_F(SpecialActionsTest, playsFromTheMeasuredAnglesToTheEnd) {
  make();
  cycle();
  EXPECT_TRUE(output.finished);
  EXPECT_FALSE(output.targets.set[lShoulderPitch]);
  selection.motion = Motion::specialAction;
  selection.specialAction = "wave";
  selection.started = true;
  joints.angles[lShoulderPitch] = 1.0;
  sensors.gyro.x() = 1;
  cycle();
  EXPECT_FALSE(output.finished);
  EXPECT_NEAR(output.targets.angles[lShoulderPitch], 0.6, 1e-9);
  for (int i = 0; i < 4; ++i) cycle();
  EXPECT_NEAR(output.targets.angles[lShoulderPitch], -1, 1e-9);
  EXPECT_FALSE(output.finished) << "waits for the torso";
  sensors.gyro.x() = 0.1;
  cycle();
  cycle();
  EXPECT_FALSE(output.finished) << "a moment of rest is not enough";
  cycle();
  EXPECT_TRUE(output.finished);
  EXPECT_TRUE(output.targets.set[lShoulderPitch]);
}

TEST_F(SpecialActionsTest, anUnknownActionIsFinishedAtOnce) {
  make();
  selection.motion = Motion::specialAction;
  selection.specialAction = "dance";
  selection.started = true;
  cycle();
  EXPECT_TRUE(output.finished);
}

TEST_F(SpecialActionsTest, aBrokenFileEndsTheAgent) {
  write("broken", "keyframes:\n  - {time: 0.1, LShoulderPich: 3}\n");
  make();
  try {
    cycle();
    FAIL();
  } catch (const ConfigurationError& error) {
    EXPECT_EQ(error.what(), (directory / "motions/broken.yaml").string() +
                                ":2: LShoulderPich: unknown joint; did you mean \"LShoulderPitch\"?");
  }
}

}  // namespace
}  // namespace plumbline
