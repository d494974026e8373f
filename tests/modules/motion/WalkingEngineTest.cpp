#include "modules/motion/WalkingEngine.h"

#include <gtest/gtest.h>

#include "ModuleUnderTest.h"
#include "modules/motion/StandMotion.h"

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
  description.type = 0;
  description.model = simsparkRobot(0);
  engine->update(&output);
  EXPECT_TRUE(output.standing);
  EXPECT_GT(output.targets.angles[lKneePitch], 0.3);
  EXPECT_FALSE(output.targets.set[headYaw]);

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
  EXPECT_FALSE(output.standing);
  EXPECT_GT(way.x(), 0.1);
  request.motion = Motion::kick;
  int cycles = 0;
  while (!output.standing && cycles < 200) {
    engine->update(&output);
    ++cycles;
  }
  EXPECT_LT(cycles, 100);
}

}  // namespace
}  // namespace plumbline
