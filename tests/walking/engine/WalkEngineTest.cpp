#include "walking/engine/WalkEngine.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <deque>

#include "robot/LegKinematics.h"
#include "simspark/LeagueRobots.h"

namespace plumbline::walking {
namespace {

constexpr double period = 0.02;

/// The engine with joints that are where it wants them: the open loop.
struct OpenLoop {
  RobotModel robot = simsparkRobot(0);
  WalkEngine engine{WalkParameters{}, robot};
  WalkSensors sensors;
  WalkOutput output;
  Pose2 odometry;

  void run(const WalkRequest& request, double seconds) {
    for (int i = 0; i < std::lround(seconds / period); ++i) {
      output = engine.update(request, sensors);
      sensors.angles = output.angles;
      odometry = odometry * output.odometry;
    }
  }
};

WalkRequest walk(double x, double y, double turn) { return {Vec2(x, y), turn, true}; }

TEST(WalkEngine, standsStillUntilAsked) {
  OpenLoop loop;
  loop.run({}, 1);
  EXPECT_TRUE(loop.output.standing);
  EXPECT_EQ(loop.output.support, Support::both);
  for (std::size_t j = 0; j < maxJoints; ++j) {
    if (!loop.output.set[j]) continue;
    EXPECT_NEAR(loop.output.angles[j], loop.engine.stand().angles[j], 1e-3)
        << loop.robot.jointName(static_cast<JointId>(j));
  }
  EXPECT_FALSE(loop.output.set[headYaw]);
  EXPECT_TRUE(loop.output.set[rAnkleRoll]);
  EXPECT_NEAR(loop.odometry.position.norm(), 0, 1e-3);
}

TEST(WalkEngine, walksAsFarAsAskedByItsOwnModel) {
  OpenLoop loop;
  loop.run(walk(0.3, 0, 0), 2);
  loop.odometry = {};
  loop.run(walk(0.3, 0, 0), 3.6);
  EXPECT_NEAR(loop.odometry.x(), 0.3 * 3.6, 0.02);
  EXPECT_NEAR(loop.odometry.y(), 0, 0.03);
  EXPECT_FALSE(loop.output.standing);
}

TEST(WalkEngine, turnsAsAsked) {
  OpenLoop loop;
  loop.run(walk(0, 0, 1.2), 1);
  double turned = 0;
  for (int i = 0; i < 100; ++i) {
    loop.run(walk(0, 0, 1.2), period);
    turned += loop.output.odometry.heading;
  }
  EXPECT_NEAR(turned, 2.4, 0.1);
}

TEST(WalkEngine, leavesTheStandWithoutSteppingOnTheSpot) {
  OpenLoop loop;
  WalkParameters parameters;
  loop.run(walk(0.2, 0, 0), parameters.startStop.duration + parameters.step.duration);
  EXPECT_GT(loop.engine.state().velocity.x(), 0.05) << "the first step goes forward";
}

TEST(WalkEngine, aStartAtASpeedIsSooner) {
  // How far it got 0.35 s after it was asked.
  const auto way = [](double startSpeed) {
    WalkParameters parameters;
    parameters.startStop.speed = startSpeed;
    OpenLoop loop;
    loop.engine = WalkEngine(parameters, loop.robot);
    loop.run({}, 0.2);
    loop.odometry = {};
    loop.run(walk(0.2, 0, 0), 0.36);
    return loop.odometry.x();
  };
  EXPECT_GT(way(0.15), way(0) + 0.01);
  EXPECT_EQ(way(0.2), way(0.3)) << "no faster than asked for";
}

TEST(WalkEngine, stopsWithFeetSideBySide) {
  OpenLoop loop;
  loop.run(walk(0.3, 0.1, 0.5), 3);
  loop.run({}, 2);
  EXPECT_TRUE(loop.output.standing);
  const Pose2 between = loop.engine.state().foot[1].inverse() * loop.engine.state().foot[0];
  EXPECT_NEAR(between.x(), 0, 0.02);
  EXPECT_NEAR(between.heading, 0, 0.1);
  EXPECT_LT(loop.engine.state().velocity.norm(), 0.02);
}

TEST(WalkEngine, turnsAsRequestedWhileItStopsAndStopsAllTheSame) {
  double turned[2];
  for (const int turns : {0, 1}) {
    OpenLoop loop;
    loop.run(walk(0.1, 0, 0), 2);
    loop.odometry = {};
    WalkRequest stop;
    stop.turn = turns;
    loop.run(stop, 2.5);
    EXPECT_TRUE(loop.output.standing) << turns;
    turned[turns] = loop.odometry.heading;
  }
  EXPECT_NEAR(turned[0], 0, 0.02);
  EXPECT_GT(turned[1], 0.1);
  EXPECT_LT(turned[1], 0.6) << "at 1 rad/s for half a second";
}

TEST(WalkEngine, requestsBeyondTheLimitsAreScaledDown) {
  OpenLoop loop;
  const WalkParameters parameters;
  loop.run(walk(9, 0, 0), 4);
  EXPECT_NEAR(loop.output.velocity.x(), parameters.speed.maxForward, 1e-9);
  loop.run(walk(9, 9 * parameters.speed.maxSideways / parameters.speed.maxForward, 0), 4);
  EXPECT_NEAR(loop.output.velocity.x(), parameters.speed.maxForward * std::sqrt(0.5), 1e-9);
  // The robot brakes before it turns: forward speed goes first, the side gets the rest of the effort.
  EXPECT_NEAR(loop.output.velocity.y(), parameters.speed.maxSideways * (1 - std::sqrt(0.5)), 1e-9);
}

TEST(WalkEngine, jointsMoveWithoutJumps) {
  OpenLoop loop;
  loop.run({}, 0.2);
  JointArray last = loop.output.angles;
  for (int i = 0; i < 250; ++i) {
    loop.run(i < 200 ? walk(0.25, 0, 0.4) : WalkRequest{}, period);
    for (std::size_t j = lShoulderPitch; j < maxJoints; ++j)
      ASSERT_LT(std::abs(loop.output.angles[j] - last[j]), 6.14 * period)
          << loop.robot.jointName(static_cast<JointId>(j)) << " in cycle " << i;
    last = loop.output.angles;
  }
}

TEST(WalkEngine, sameCallsSameAnswers) {
  OpenLoop a, b;
  a.run(walk(0.2, 0.1, -0.3), 3);
  b.run({}, 0);
  b.engine.reset();
  b.run(walk(0.2, 0.1, -0.3), 3);
  EXPECT_EQ(a.output.angles, b.output.angles);
}

TEST(WalkEngine, resetIsTheStand) {
  OpenLoop loop;
  loop.run(walk(0.3, 0, 0), 1.3);
  loop.engine.reset();
  loop.run({}, period);
  EXPECT_TRUE(loop.output.standing);
  EXPECT_NEAR(loop.output.odometry.position.norm(), 0, 1e-3);
}

/// The engine in closed loop with a robot that moves as the model says, measured two cycles late.
struct PerfectRobot {
  RobotModel robot = simsparkRobot(0);
  WalkEngine engine;
  std::deque<JointArray> underway;
  WalkSensors sensors;
  WalkOutput output;

  explicit PerfectRobot(const WalkParameters& parameters) : engine(parameters, robot) {
    underway.assign(2, engine.stand().angles);
  }
  void cycle(const WalkRequest& request) {
    sensors.angles = underway.front();
    underway.pop_front();
    output = engine.update(request, sensors);
    underway.push_back(output.angles);
  }
};

WalkParameters closedLoop() {
  WalkParameters p;
  p.model.pendulumHeight = 0.22;
  p.observation.positionGain = 0.1;
  p.observation.velocityGain = 0.1;
  return p;
}

TEST(WalkEngine, closedLoopWithAPerfectRobotIsTheOpenLoop) {
  WalkParameters open = closedLoop();
  open.observation.positionGain = open.observation.velocityGain = 0;
  PerfectRobot a(closedLoop()), b(open);
  double worst = 0;
  for (int i = 0; i < 300; ++i) {
    const WalkRequest request = i < 200 ? walk(0.2, 0.05, 0.2) : WalkRequest{};
    a.cycle(request);
    b.cycle(request);
    worst = std::max(worst, (a.engine.state().velocity - b.engine.state().velocity).norm());
  }
  EXPECT_LT(worst, 0.08);
  EXPECT_TRUE(a.output.standing);
}

TEST(WalkEngine, observedVelocityIsThatOfAPerfectRobot) {
  PerfectRobot robot(closedLoop());
  std::deque<Vec2> planned(1, Vec2::Zero());
  double squares = 0;
  int count = 0;
  for (int i = 0; i < 300; ++i) {
    robot.cycle(walk(0.2, 0, 0));
    planned.push_back(robot.engine.state().velocity);
    const Vec2 then = planned.front();
    if (planned.size() > 2) planned.pop_front();
    if (i < 50) continue;
    squares += (robot.engine.observed().velocity - then).squaredNorm();
    ++count;
  }
  EXPECT_LT(std::sqrt(squares / count), 0.06);
}

TEST(WalkEngine, theWalkStateIsDrawnSlowlyToTheObservedOne) {
  WalkParameters p = closedLoop();
  PerfectRobot robot(p);
  for (int i = 0; i < 20; ++i) robot.cycle({});
  robot.sensors.torsoAngles.y() = 0.05;  // the whole robot leans forward: the feet are behind its mass
  robot.cycle({});
  const double first = robot.engine.state().foot[0].x();
  EXPECT_LT(first, -0.0005);
  EXPECT_GT(first, -0.005) << "not at once";
}

TEST(WalkEngine, stepsAreObserved) {
  PerfectRobot robot(closedLoop());
  int steps = 0;
  for (int i = 0; i < 250; ++i) {
    robot.cycle(walk(0.1, 0, 0));
    if (const ObservedStep* step = robot.engine.observedStep()) {
      ++steps;
      EXPECT_GT(step->samples.size(), 3u);
      EXPECT_NEAR(step->pendulum.heights.x(), 0.22, 1e-12);
    }
  }
  EXPECT_NEAR(steps, 5 / 0.18, 4);
}

TEST(WalkEngine, theHipsOfTheCarryingLegsTurnTheTorsoBack) {
  WalkParameters p;
  const auto hips = [&](const Vec2& tilt) {
    WalkEngine engine(p, simsparkRobot(0));
    WalkSensors sensors;
    sensors.torsoAngles = tilt;
    return engine.update({}, sensors).angles;
  };
  const JointArray without = hips(Vec2(0.1, 0.2));
  p.feedback.hipRollGain = 0.3;
  p.feedback.hipPitchGain = 0.5;
  const JointArray with = hips(Vec2(0.1, 0.2));
  for (const JointId joint : {lHipRoll, rHipRoll}) EXPECT_NEAR(with[joint] - without[joint], 0.03, 1e-9);
  for (const JointId joint : {lHipPitch, rHipPitch}) EXPECT_NEAR(with[joint] - without[joint], 0.1, 1e-9);
  EXPECT_DOUBLE_EQ(with[lKneePitch], without[lKneePitch]);
  EXPECT_EQ(hips(Vec2::Zero()), hips(Vec2::Zero()));
}

TEST(WalkEngine, constantHipHeightKeepsTheSupportingHip) {
  const RobotModel robot = simsparkRobot(0);
  const LegKinematics left(robot, Side::left), right(robot, Side::right);
  // How far the supporting hip comes up and down within the steps.
  const auto range = [&](double constantHipHeight) {
    WalkParameters p;
    p.posture.torsoRoll = 0.05;
    p.posture.constantHipHeight = constantHipHeight;
    WalkEngine engine(p, robot);
    double low = 1, high = 0;
    for (int i = 0; i < 150; ++i) {
      const WalkOutput out = engine.update(walk(0, 0, 0), {});
      if (i < 50) continue;
      const bool onLeft = out.support == Support::left;
      LegAngles angles{};
      std::copy_n(out.angles.begin() + firstLegJoint(onLeft ? Side::left : Side::right), 6, angles.begin());
      const LegKinematics& leg = onLeft ? left : right;
      // The hip over the flat sole.
      const double height = (leg.sole(angles).inverse() * leg.hip()).z();
      low = std::min(low, height);
      high = std::max(high, height);
    }
    return high - low;
  };
  EXPECT_LT(range(1), 1e-4);
  EXPECT_GT(range(0), 1.5e-3);
}

TEST(WalkEngine, walksToATargetAndStopsThere) {
  OpenLoop loop;
  const Pose2 target(0.6, 0.15, 0.5);
  int cycles = 0;
  WalkRequest request;
  request.walk = true;
  for (; cycles < 800; ++cycles) {
    request.target = loop.odometry.inverse() * target;
    loop.run(request, period);
    if (cycles > 20 && loop.output.standing) break;
  }
  EXPECT_LT(cycles, 500) << loop.odometry.position.transpose() << " " << loop.odometry.heading << " "
                         << loop.output.stepsToTarget;
  EXPECT_NEAR((loop.odometry.position - target.position).norm(), 0, 0.05);
  EXPECT_NEAR(loop.odometry.heading, 0.5, 0.1);
}

TEST(WalkEngine, aTargetTwoCentimetresAwayIsReachedAlready) {
  const auto steps = [](const Pose2& target) {
    OpenLoop loop;
    loop.run({}, 0.2);
    WalkRequest request;
    request.walk = true;
    request.target = target;
    loop.run(request, period);
    return loop.output.stepsToTarget;
  };
  EXPECT_EQ(steps(Pose2(0.022, 0, 0)), 0U);
  EXPECT_EQ(steps(Pose2(0, -0.022, 0)), 0U);
  EXPECT_EQ(steps(Pose2(0, 0, 0.07)), 0U);
  EXPECT_GT(steps(Pose2(0.04, 0, 0)), 0U);
  EXPECT_GT(steps(Pose2(0, 0, 0.12)), 0U);
}

TEST(WalkEngine, kicksWithAStep) {
  OpenLoop loop;
  WalkRequest request = walk(0, 0, 0);
  loop.run(request, 1);
  request.kick = Side::right;
  double back = 0, forward = 0;
  int kicking = 0, cycles = 0;
  for (; cycles < 100 && !loop.output.kicked; ++cycles) {
    loop.run(request, period);
    if (!loop.output.kicking) continue;
    ++kicking;
    EXPECT_EQ(loop.output.support, Support::left);
    const WalkState& state = loop.engine.state();
    const double ahead = (state.foot[0].inverse() * state.foot[1]).x();
    back = std::min(back, ahead);
    forward = std::max(forward, ahead);
  }
  EXPECT_LT(cycles, 100);
  const WalkParameters p;
  EXPECT_NEAR(kicking * period, p.kick.duration, 0.06) << "a longer step";
  EXPECT_LT(back, -0.5 * p.kick.back);
  EXPECT_GT(forward, 0.6 * p.kick.forward);
  // Once only, and the walk goes on.
  for (int i = 0; i < 50; ++i) {
    loop.run(request, period);
    EXPECT_FALSE(loop.output.kicking);
  }
  loop.run({}, 2);
  EXPECT_TRUE(loop.output.standing);
}

TEST(WalkEngine, otherParametersCountFromTheNextCycleOn) {
  WalkParameters parameters;
  WalkEngine engine(parameters, simsparkRobot(0));
  parameters.posture.hipHeight = 0.19;
  engine.setGaits(WalkGaits(parameters));
  WalkSensors sensors;
  engine.update({}, sensors);
  EXPECT_EQ(engine.gait().posture.hipHeight, 0.19);
  parameters.step.height = 0.5;
  EXPECT_THROW(engine.setGaits(WalkGaits(parameters)), std::invalid_argument);
  engine.update({}, sensors);
  EXPECT_EQ(engine.gait().step.height, 0.02);
}

}  // namespace
}  // namespace plumbline::walking
