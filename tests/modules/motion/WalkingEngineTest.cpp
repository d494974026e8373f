#include "modules/motion/WalkingEngine.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>

#include "ModuleUnderTest.h"
#include "framework/ConfigurationError.h"
#include "modules/motion/StandMotion.h"
#include "simspark/LeagueRobots.h"
#include "walking/planning/SpeedLimits.h"

namespace plumbline {
namespace {

struct Engine : public WalkingEngine {
  using WalkingEngine::theFrameInfo;
  using WalkingEngine::theJointData;
  using WalkingEngine::theMotionRequest;
  using WalkingEngine::theMotionSelection;
  using WalkingEngine::theRobotDescription;
  using WalkingEngine::theSensorData;
  using WalkingEngine::theTorsoAngles;
};
struct Stand : public StandMotion {
  using StandMotion::theRobotDescription;
};

TEST(WalkingEngineTest, walksWhileSelectedAndStopsForOthers) {
  ModuleUnderTest<Engine> engine("WalkingEngine");
  FrameInfo frame;
  RobotDescription description;
  MotionRequest request;
  MotionSelection selection;
  JointData joints;
  SensorData sensors;
  TorsoAngles angles;
  WalkingEngineOutput output;
  engine->theFrameInfo = &frame;
  engine->theRobotDescription = &description;
  engine->theMotionRequest = &request;
  engine->theMotionSelection = &selection;
  engine->theJointData = &joints;
  engine->theSensorData = &sensors;
  engine->theTorsoAngles = &angles;

  engine->update(&output);
  EXPECT_FALSE(output.targets.set[lKneePitch]) << "the robot is not known yet";
  description.model = simsparkRobot(0);
  description.name = description.model.name;
  engine->update(&output);
  EXPECT_TRUE(output.finished);
  EXPECT_GT(output.targets.angles[lKneePitch], 0.3);
  EXPECT_FALSE(output.targets.set[headYaw]);
  EXPECT_EQ(output.limits, walking::walkLimits(engine->walk.base));
  EXPECT_GT(output.limits.forward, 0.2);

  ModuleUnderTest<Stand> stand("StandMotion");
  StandOutput standOutput;
  stand->theRobotDescription = &description;
  stand->update(&standOutput);
  EXPECT_EQ(standOutput.targets.angles, output.targets.angles) << "walk and stand stand alike";
  EXPECT_EQ(standOutput.targets.set, output.targets.set);

  selection.motion = request.motion = Motion::walk;
  request.walkVelocity = Vec2(0.2, 0);
  selection.started = true;
  Pose2 way;
  for (int i = 0; i < 100; ++i) {
    engine->update(&output);
    selection.started = false;
    way = way * output.odometry;
  }
  EXPECT_FALSE(output.finished);
  EXPECT_GT(way.x(), 0.1);
  request.motion = Motion::kick;
  int cycles = 0;
  while (!output.finished && cycles < 200) {
    engine->update(&output);
    ++cycles;
  }
  EXPECT_LT(cycles, 100);
}

class WalkParametersAtRunTime : public testing::Test {
protected:
  ModuleUnderTest<Engine> engine{"WalkingEngine", {"config", "config/robots/simspark_type0"}};

  std::string get(const std::string& path) {
    return moduleParameter(*engine.operator->(), Engine::moduleDescription(), path);
  }
  std::string set(const std::string& path, const std::string& text) {
    try {
      setModuleParameter(*engine.operator->(), Engine::moduleDescription(), path, text);
    } catch (const ConfigurationError& error) {
      return error.what();
    }
    return "";
  }
};

TEST_F(WalkParametersAtRunTime, areReadAndSetByTheirPath) {
  EXPECT_EQ(get("walk.posture.hipHeight"), "0.218");
  EXPECT_EQ(get("walk.gaits.forward.posture.hipHeight"), "0.23171");
  EXPECT_EQ(get("walk.gaits.recovery.posture.hipHeight"), "nan") << "the same as what is walked";
  EXPECT_EQ(set("walk.posture.hipHeight", "0.21"), "");
  EXPECT_EQ(get("walk.posture.hipHeight"), "0.21");
  EXPECT_EQ(get("walk.gaits.forward.posture.hipHeight"), "0.23171");
  EXPECT_EQ(set("walk.gaits.turn.posture.hipHeight", "0.2"), "");
  EXPECT_EQ(get("walk.gaits.turn.posture.hipHeight"), "0.2");
}

TEST_F(WalkParametersAtRunTime, gaitsThatWereAsTheBaseFollowIt) {
  EXPECT_EQ(get("walk.gaits.backward.arms.elbowRoll"), "0.6");
  EXPECT_EQ(set("walk.arms.elbowRoll", "0.7"), "");
  EXPECT_EQ(get("walk.gaits.backward.arms.elbowRoll"), "0.7");
}

TEST_F(WalkParametersAtRunTime, aRefusedValueChangesNothing) {
  EXPECT_EQ(set("walk.posture.hipHeight", "2"),
            "WalkingEngine.walk.posture.hipHeight must be within [0.1, 0.4], not 2");
  EXPECT_EQ(set("walk.step.minDuration", "0.5"),
            "walking parameter step.minDuration must be within [0, 0.09523], not 0.5");
  EXPECT_EQ(get("walk.step.minDuration"), "0.085");
  EXPECT_EQ(get("walk.gaits.forward.step.minDuration"), "0.087383");
  EXPECT_NE(set("walk.step.hight", "0.02").find("did you mean \"walk.step.height\"?"), std::string::npos);
}

TEST(WalkingEngineConfiguration, theWalkStandsInItsOwnFile) {
  const std::filesystem::path folder = std::filesystem::path(testing::TempDir()) / "walking_engine_test";
  std::filesystem::create_directories(folder);
  std::ofstream(folder / "WalkingEngine.yaml") << "walk: {step: {height: 0.03}}\n";
  try {
    ModuleUnderTest<Engine> engine("WalkingEngine", {"config", folder.string()});
    FAIL() << "accepted";
  } catch (const ConfigurationError& error) {
    EXPECT_EQ(std::string(error.what()), (folder / "WalkingEngine.yaml").string() +
                                             ":1: walk is set in walking.yaml, for all programs that walk");
  }
}

}  // namespace
}  // namespace plumbline
