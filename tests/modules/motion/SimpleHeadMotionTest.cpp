#include "modules/motion/SimpleHeadMotion.h"

#include <gtest/gtest.h>

#include "ModuleUnderTest.h"

namespace plumbline {
namespace {

struct Head : public SimpleHeadMotion {
  using SimpleHeadMotion::theBallPos;
  using SimpleHeadMotion::theFieldDimensions;
  using SimpleHeadMotion::theFrameInfo;
  using SimpleHeadMotion::theRobotPose;
};

TEST(SimpleHeadMotionTest, looksAtTheBallAndSearchesALostOneOnTheOtherSideFirst) {
  ModuleUnderTest<Head> head("SimpleHeadMotion");
  FrameInfo frame;
  BallPos ball;
  HeadMotionRequest request;
  head->theFrameInfo = &frame;
  head->theBallPos = &ball;
  ball.valid = true;
  ball.age = 0.02;
  ball.relative = Vec2(1, -1);
  head->update(&request);
  EXPECT_NEAR(request.yaw, -pi / 4, 1e-9);
  ball.age = 5;
  frame.time = 10;
  head->update(&request);
  EXPECT_NEAR(request.yaw, -pi / 4, 1e-9);
  ball.relative = Vec2(1, 1);  // believed elsewhere as the robot turns: the scan goes on
  frame.time = 10.2;
  head->update(&request);
  EXPECT_NEAR(request.yaw, -pi / 4 + 0.2 * 4 * 2.05 / 1.4, 1e-9);
  frame.time = 10.7;
  head->update(&request);
  EXPECT_NEAR(request.yaw, 2 * 2.05 - (-pi / 4 + 0.7 * 4 * 2.05 / 1.4), 1e-9) << "back from the left";
}

TEST(SimpleHeadMotionTest, aLocalisedRobotTurnsTowardsLandmarks) {
  ModuleUnderTest<Head> head("SimpleHeadMotion");
  FrameInfo frame;
  BallPos ball;
  RobotPose pose;
  FieldDimensions field;
  HeadMotionRequest request;
  head->theFrameInfo = &frame;
  head->theBallPos = &ball;
  head->theRobotPose = &pose;
  head->theFieldDimensions = &field;
  ball.valid = true;
  ball.age = 0;
  ball.relative = Vec2(1, 0);
  pose.valid = true;
  pose.pose = Pose2(0, 9, 0.8);
  head->update(&request);
  EXPECT_LT(request.yaw, -0.3);
  EXPECT_GT(request.yaw, -0.9);
}

TEST(SimpleHeadMotionTest, withoutAnyModelItLooksAround) {
  ModuleUnderTest<Head> head("SimpleHeadMotion");
  FrameInfo frame;
  HeadMotionRequest request;
  head->theFrameInfo = &frame;
  head->update(&request);
  frame.time = 0.35;
  head->update(&request);
  EXPECT_NEAR(request.yaw, 2.05, 1e-9);
}

}  // namespace
}  // namespace plumbline
