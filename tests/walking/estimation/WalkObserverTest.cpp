#include "walking/estimation/WalkObserver.h"

#include <gtest/gtest.h>

#include <cmath>

#include "simspark/LeagueRobots.h"
#include "walking/engine/BodyPosture.h"
#include "walking/model/LinearInvertedPendulum.h"

namespace plumbline::walking {
namespace {

class WalkObserverTest : public testing::Test {
protected:
  static constexpr double dt = 0.02;
  RobotModel robot = simsparkRobot(0);
  BodyPosture posture{robot};
  WalkObserver observer{robot};
  LinearInvertedPendulum model{0.22};
  WalkSensors sensors;

  /// Joints that carry the torso like this over these feet; the IMU tells the truth.
  void pose(const Pose2& left, const Pose2& right, double roll, double pitch) {
    std::array<FootPlacement, 2> feet;
    feet[0].ground = left;
    feet[1].ground = right;
    for (int i = 0; i < 4; ++i)
      posture.solve(feet, {.hipHeight = 0.2, .roll = roll, .pitch = pitch}, sensors.angles);
    sensors.torsoAngles = Vec2(roll, pitch);
  }
  void observe(Support support, double average = 0) {
    WalkAction action;
    action.duration = dt;
    observer.update(sensors, support, action, model, average);
  }
};

TEST_F(WalkObserverTest, seesTheFeetWhereTheyAreWhateverTheTorsosAngle) {
  for (const Vec2& tilt : {Vec2(0, 0), Vec2(0.1, 0), Vec2(-0.05, 0.15)}) {
    pose(Pose2(0.02, 0.06, 0.1), Pose2(-0.03, -0.05, -0.1), tilt.x(), tilt.y());
    observe(Support::left);
    EXPECT_NEAR((observer.state().foot[0].position - Vec2(0.02, 0.06)).norm(), 0, 1e-3);
    EXPECT_NEAR((observer.state().foot[1].position - Vec2(-0.03, -0.05)).norm(), 0, 1e-3);
    EXPECT_NEAR(observer.state().foot[0].heading, 0.1, 2e-3);
    EXPECT_NEAR(observer.state().foot[1].heading, -0.1, 2e-3);
  }
}

TEST_F(WalkObserverTest, aRobotThatTipsOverIsSeenToMoveItsMass) {
  pose(Pose2(0, 0.05), Pose2(0, -0.05), 0, 0);
  observe(Support::both);
  const double before = observer.state().foot[0].x();
  sensors.torsoAngles.y() = 0.1;  // the whole robot leans forward
  observe(Support::both);
  // The mass is about 0.2 m over the soles.
  EXPECT_NEAR(observer.state().foot[0].x() - before, -0.1 * 0.2, 0.006);
  EXPECT_GT(observer.seenVelocity().x(), 0.7);
}

TEST_F(WalkObserverTest, theFootsMovementIsTheMassesVelocity) {
  for (int i = 0; i < 15; ++i) {
    pose(Pose2(0.05 - 0.3 * dt * i, 0.05), Pose2(0, -0.05), 0, 0);
    observe(Support::left);
  }
  EXPECT_NEAR(observer.seenVelocity().x(), 0.3, 0.01);
  EXPECT_NEAR(observer.state().velocity.x(), 0.3, 0.06);
}

TEST_F(WalkObserverTest, aFootThatRollsOverItsEdgeShowsTheVelocityThere) {
  // The right foot is said to carry but hangs in the air; the left one rolls over its front edge with the
  // robot, which turns about that edge as a whole.
  pose(Pose2(0, 0.05), Pose2(0, -0.05), 0, 0);
  const ForwardKinematics kinematics = [&] {
    ForwardKinematics k(robot);
    k.update(sensors.angles);
    return k;
  }();
  const LegKinematics leg(robot, Side::left);
  const int link = robot.linkOfJoint[lAnkleRoll];
  const Link& foot = robot.links[static_cast<std::size_t>(link)];
  const Vec3 edge = leg.T_foot_sole() * Vec3(leg.soleHalfSize().x(), 0, 0);
  const double weight = 9.81 * robot.totalMass();
  sensors.feet.emplace();
  sensors.feet->foot[0] = FootContact{edge - foot.com, Vec3(0, 0, weight)};
  observe(Support::right);
  constexpr double rate = 0.5;  // [rad/s]
  sensors.torsoAngles.y() = rate * dt;
  sensors.gyro.y() = rate;
  observe(Support::right);
  const Vec3 fromEdge = kinematics.com() - kinematics.link(link) * edge;
  EXPECT_NEAR(observer.seenVelocity().x(), rate * fromEdge.z(), 0.01);
  EXPECT_NEAR(observer.seenVelocity().y(), 0, 1e-3);
}

TEST_F(WalkObserverTest, inTheAirTheForcesAloneTellTheVelocity) {
  pose(Pose2(0, 0.05), Pose2(0, -0.05), 0, 0);
  const double mass = robot.totalMass();
  sensors.feet.emplace();
  // Pushed off with 0.5 m/s^2 for half a second, then nothing touches the ground.
  sensors.feet->foot[0] = FootContact{Vec3::Zero(), Vec3(0.5 * mass, 0, 1e-9)};
  for (int i = 0; i < 25; ++i) observe(Support::left);
  sensors.feet->foot[0].reset();
  const double left = observer.state().velocity.x();
  for (int i = 0; i < 5; ++i) observe(Support::left);
  EXPECT_NEAR(observer.state().velocity.x(), left, 0.08);
}

TEST_F(WalkObserverTest, meanDifferenceOfImuAndLegsIsTrackedAndTakenOff) {
  pose(Pose2(0, 0.05), Pose2(0, -0.05), 0, 0.03);
  sensors.torsoAngles.y() -= 0.08;  // as one of the thesis's robots, table 4.1
  for (int i = 0; i < 1000; ++i) observe(Support::both, 2.0);
  EXPECT_NEAR(observer.imuDifference().y(), -0.08, 1e-3);
  EXPECT_NEAR(observer.imuDifference().x(), 0, 1e-3);
  EXPECT_NEAR(observer.torsoAngles().y(), 0.03, 1e-3);
  // Without the option it is reported, and the IMU believed.
  observe(Support::both, 0);
  EXPECT_NEAR(observer.imuDifference().y(), -0.08, 1e-3);
  EXPECT_NEAR(observer.torsoAngles().y(), -0.05, 1e-9);
}

}  // namespace
}  // namespace plumbline::walking
