#include "modules/infrastructure/DrawingFrames.h"

#include <gtest/gtest.h>

#include <numbers>

#include "framework/Controller.h"
#include "framework/DebugPoints.h"

namespace plumbline {
namespace {

/// With inputs set by hand.
struct Frames : DrawingFrames {
  using DrawingFrames::theFKModel;
  using DrawingFrames::thePlayerInfo;
  using DrawingFrames::theRobotDescription;
  using DrawingFrames::theRobotPose;
  using DrawingFrames::theTorsoPose;
};

struct Look final : DebugRequest {
  void serve(DebugValue& value) noexcept override { drawing = *value.drawing(); }
  Drawing drawing;
};

TEST(DrawingFramesTest, tellsWhereRobotAndTorsoAre) {
  Frames frames;
  PlayerInfo player;
  RobotPose pose;
  TorsoPose torso;
  FKModel body;
  RobotDescription robot;
  frames.thePlayerInfo = &player;
  frames.theRobotPose = &pose;
  frames.theTorsoPose = &torso;
  frames.theFKModel = &body;
  frames.theRobotDescription = &robot;
  pose.pose = Pose2(3, 1, std::numbers::pi);
  pose.positionDeviation = 0.25;
  torso.T_ground_torso = translation(0, 0, 0.4);
  frames.execute();

  Drawing drawing;
  drawing.in(DrawingFrame::torso);
  drawing.point(Vec3(1, 0, 0), colours::red);
  EXPECT_TRUE(std::get<shapes::Point>(drawing.shapes()[0].form).position.isApprox(Vec3(2, 1, 0.4)));

  const auto look = std::make_shared<Look>();
  ASSERT_TRUE(DebugPoints::sites().attach("draw:RobotPose", look));
  frames.execute();
  DebugPoints::sites().detach("draw:RobotPose", look);
  const auto& circle = std::get<shapes::Circle>(look->drawing.shapes().at(0).form);
  EXPECT_EQ(circle.centre, Vec2(3, 1));
  EXPECT_EQ(circle.radius, 0.25) << "as large as the pose is uncertain";
  setDrawingFrames({}, Pose3::Identity());
}

}  // namespace
}  // namespace plumbline
