#include "motion/Gaze.h"

#include <gtest/gtest.h>

#include <cmath>

namespace plumbline::motion {
namespace {

const std::vector<Vec2> landmarks = {{-15, 10},   {-15, -10},   {15, 10},   {15, -10},
                                     {-15, 1.05}, {-15, -1.05}, {15, 1.05}, {15, -1.05}};

TEST(GazeTest, looksStraightAtTheBallWhenLost) {
  const GazeParameters p;
  const HeadAngles head = lookAtBall(Vec2(2, 1), std::nullopt, landmarks, 0, p);
  EXPECT_NEAR(head.yaw, std::atan2(1, 2), 1e-12);
  EXPECT_NEAR(lookAtBall(Vec2(-1, 0.001), std::nullopt, landmarks, 0, p).yaw, p.maxYaw, 1e-12);
}

TEST(GazeTest, theBallStaysInView) {
  const GazeParameters p;
  for (double bearing = -2.9; bearing < 3; bearing += 0.1)
    for (double distance : {0.12, 0.2, 0.3, 1.0, 8.0}) {
      const Vec2 ball = distance * Vec2(std::cos(bearing), std::sin(bearing));
      const HeadAngles head = lookAtBall(ball, Pose2(3, 2, 1), landmarks, 0.5, p);
      EXPECT_LE(std::abs(head.yaw), p.maxYaw);
      EXPECT_LE(head.pitch, p.maxPitch);
      EXPECT_GE(head.pitch, p.minPitch);
      EXPECT_LT(std::abs(bearing - head.yaw), p.halfView) << bearing;
      // Down to where the pitch's limit ends it the ball is in the cone vertically, too.
      if (distance >= 0.2) {
        EXPECT_LT(std::abs(std::atan2(p.cameraHeight, distance) - head.pitch), p.halfView) << distance;
      }
    }
}

TEST(GazeTest, turnsTowardsLandmarksWithinTheFreedom) {
  const GazeParameters p;
  // At the left side line looking outwards; the ball lies ahead, the field to the right.
  const Pose2 robot(0, 9, 0.8);
  const HeadAngles head = lookAtBall(Vec2(1, 0), robot, landmarks, 0, p);
  EXPECT_LT(head.yaw, -0.3);
  EXPECT_GE(head.yaw, -(p.halfView - p.ballMargin));
}

TEST(GazeTest, scanCoversBothSidesAndBeginsOnTheGivenOne) {
  const GazeParameters p;
  EXPECT_NEAR(scan(0, 0, 1, p).yaw, 0, 1e-12);
  EXPECT_NEAR(scan(p.scanSeconds / 4, 0, 1, p).yaw, p.scanYaw, 1e-9);
  EXPECT_NEAR(scan(p.scanSeconds / 4, 0, -1, p).yaw, -p.scanYaw, 1e-9);
  EXPECT_NEAR(scan(p.scanSeconds * 3 / 4, 0, 1, p).yaw, -p.scanYaw, 1e-9);
  EXPECT_NEAR(scan(p.scanSeconds * 2, 0, 1, p).yaw, 0, 1e-9);
}

TEST(GazeTest, scanGoesOnFromWhereTheHeadIs) {
  GazeParameters p;
  p.scanYaw = 2;
  p.scanSeconds = 4;  // 2 rad/s
  EXPECT_NEAR(scan(0, 1.5, -1, p).yaw, 1.5, 1e-12);
  EXPECT_NEAR(scan(1, 1.5, -1, p).yaw, -0.5, 1e-9);
  EXPECT_NEAR(scan(2, 1.5, -1, p).yaw, -1.5, 1e-9) << "it turned back at -2";
  EXPECT_NEAR(scan(0.5, 1.5, 1, p).yaw, 1.5, 1e-9) << "it turned back at 2";
  EXPECT_NEAR(scan(0, 3, -1, p).yaw, 2, 1e-12) << "beyond its turning point it begins there";
}

}  // namespace
}  // namespace plumbline::motion
