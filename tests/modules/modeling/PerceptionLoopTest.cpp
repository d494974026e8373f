// Everything from the simulator's message to pose, ball, tilt and falls, on the league's physics with the
// walk engine driving: what the estimates are worth against the ground truth.
#include <gtest/gtest.h>

#include "framework/Controller.h"
#include "framework/Module.h"
#include "math/GroundPose.h"
#include "modules/evaluation/ErrorStatistics.h"
#include "modules/simspark/AgentOptions.h"
#include "representations/infrastructure/GroundTruth.h"
#include "representations/infrastructure/ServerMessageText.h"
#include "representations/modeling/BallPos.h"
#include "representations/modeling/FallState.h"
#include "representations/modeling/Odometry.h"
#include "representations/modeling/RobotPose.h"
#include "representations/modeling/TorsoAngles.h"
#include "representations/modeling/TorsoPose.h"
#include "support/InProcessServer.h"
#include "support/PerceptionModules.h"

namespace plumbline {

using namespace test;

namespace {

class PerceptionLoop {
public:
  explicit PerceptionLoop(const InProcessServer::Setup& setup)
      : server(setup), controller_(ControllerOptions{}, perceptionModules()) {
    options_->type = setup.type;
    controller_.objects().set(options_);
    controller_.objects().set(text_);
  }

  /// The agent's cycle on the present message.
  void perceive() {
    text_->text = server.message();
    controller_.runCycles(1);
  }
  template <typename R>
  const R& get() const {
    return *controller_.find<R>();
  }
  Pose2 truth() const { return groundPose(get<GroundTruth>().T_field_torso); }
  double positionError() const { return (get<RobotPose>().pose.position - truth().position).norm(); }
  double headingError() const {
    return std::abs(toDegrees(normalizeAngle(get<RobotPose>().pose.heading - truth().heading)));
  }
  double tiltError() const {
    const Vec3 up = get<GroundTruth>().T_field_torso.linear().row(2);
    return toDegrees(std::acos(std::clamp(up.dot(get<UprightVec>().up), -1.0, 1.0)));
  }

  InProcessServer server;

private:
  std::shared_ptr<AgentOptions> options_ = std::make_shared<AgentOptions>();
  std::shared_ptr<MessageSource> text_ = std::make_shared<MessageSource>();
  Controller controller_;
};

TEST(PerceptionLoop, estimatesWhileWalking) {
  for (const auto& [type, leftSide] : {std::pair(0, true), std::pair(4, false)}) {
    PerceptionLoop loop({.type = type, .seed = 3, .leftSide = leftSide});
    ErrorStatistics position, heading, ball, tilt, height;
    double way = 0;
    Pose2 drift, before;
    for (int i = 0; i < 1500; ++i) {
      loop.perceive();
      ASSERT_FALSE(loop.server.robot().fallen());
      ASSERT_TRUE(loop.get<RobotPose>().valid) << "cycle " << i;
      position.add(loop.positionError());
      heading.add(loop.headingError());
      tilt.add(loop.tiltError());
      const GroundTruth& truth = loop.get<GroundTruth>();
      height.add(std::abs(loop.get<TorsoPose>().T_ground_torso.translation().z() -
                          truth.T_field_torso.translation().z()));
      if (loop.get<BallPos>().valid) ball.add((loop.get<BallPos>().field - truth.ball.head<2>()).norm());
      if (i > 0) way += (loop.truth().position - before.position).norm();
      before = loop.truth();
      loop.server.walk(Vec2(0.25, 0), 0.4 * std::sin(i * 0.01));
    }
    EXPECT_GT(way, 4) << "it walks";
    EXPECT_LT(position.quantile(0.5), 0.008);
    EXPECT_LT(position.quantile(0.95), 0.015);
    EXPECT_LT(heading.quantile(0.95), 0.15);
    EXPECT_LT(tilt.quantile(0.95), 0.2);
    EXPECT_LT(height.quantile(0.95), 0.004);
    EXPECT_GT(ball.count(), 1000u);
    EXPECT_LT(ball.quantile(0.5), 0.04);
    EXPECT_LT(ball.quantile(0.95), 0.1);
    EXPECT_EQ(loop.get<FallState>().falls, 0);
  }
}

TEST(PerceptionLoop, odometryGoesTheTrueWay) {
  PerceptionLoop loop({});
  loop.perceive();
  const Pose2 start = loop.truth(), startOdometry = loop.get<Odometry>().total;
  for (int i = 0; i < 500; ++i) {
    loop.server.walk(Vec2(0.25, 0), 0.3);
    loop.perceive();
  }
  const Pose2 truth = start.inverse() * loop.truth();
  const Pose2 measured = startOdometry.inverse() * loop.get<Odometry>().total;
  EXPECT_LT((measured.position - truth.position).norm(), 0.05 * truth.position.norm() + 0.02);
  EXPECT_NEAR(measured.heading, truth.heading, fromDegrees(0.2));
}

TEST(PerceptionLoop, findsItselfAfterBeingCarried) {
  PerceptionLoop loop({});
  const auto walk = [&](int cycles) {
    for (int i = 0; i < cycles; ++i) {
      loop.perceive();
      loop.server.walk(Vec2(0.1, 0), 0);
    }
  };
  walk(100);
  loop.server.carry(Pose2(-10, -6, -2));
  walk(50);
  EXPECT_LT(loop.positionError(), 0.03);
  EXPECT_LT(loop.headingError(), 0.5);
}

TEST(PerceptionLoop, knowsHowItFell) {
  for (const bool forward : {true, false}) {
    PerceptionLoop loop({});
    loop.server.robot().restart(Pose2(-3, 1, 0.2));  // knees straight
    for (int i = 0; i < 20; ++i) {
      loop.perceive();
      loop.server.move(JointArray{});
    }
    // Both ankles push until the robot topples.
    JointArray push{};
    push[lAnklePitch] = push[rAnklePitch] = forward ? -0.6 : 0.6;
    for (int i = 0; i < 58; ++i) {
      loop.perceive();
      loop.server.move(push);
    }
    double worst = 0;
    for (int i = 0; i < 200; ++i) {
      loop.perceive();
      worst = std::max(worst, loop.tiltError());
      loop.server.move(JointArray{});
    }
    EXPECT_EQ(loop.get<FallState>().posture, forward ? Posture::onFront : Posture::onBack);
    EXPECT_EQ(loop.get<FallState>().falls, 1);
    EXPECT_FALSE(loop.get<TorsoPose>().valid);
    EXPECT_LT(worst, 1);
    EXPECT_LT(loop.tiltError(), 0.2) << "lying";
    EXPECT_LT(loop.positionError(), 0.1) << "it still knows where it lies";
  }
}

}  // namespace
}  // namespace plumbline
