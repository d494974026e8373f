#include "simulation/league/SoccerWorld.h"

#include <gtest/gtest.h>

#include <cstring>
#include <limits>
#include <thread>

#include "math/Angle.h"
#include "simspark/LeagueRobots.h"
#include "simulation/league/MakeWorld.h"

namespace plumbline::simulation {
namespace {

void run(World& world, int cycles) {
  for (int i = 0; i < cycles; ++i) world.step();
}

double height(const World& world, RobotHandle robot) { return world.torso(robot).pose.translation().z(); }

TEST(SoccerWorld, standsAsHighAsOnTheLeaguesServer) {
  const double nominal[] = {0.385, 0.42164, 0.385, 0.440737, 0.385};
  const double league[] = {0.38387, 0.42051, 0.38387, 0.43962, 0.38388};
  const auto world = makeWorld();
  for (int type = 0; type < numSimsparkTypes(); ++type) {
    world->reset();
    const RobotHandle robot = world->addRobot(simsparkRobot(type), translation(-5, 0, nominal[type] + 0.005));
    run(*world, 100);
    EXPECT_NEAR(height(*world, robot), league[type], 2e-5) << "type " << type;
    const RobotReadings& readings = world->readings(robot);
    double force = 0;
    for (const auto* foot : {&readings.leftFoot, &readings.rightFoot, &readings.leftToe, &readings.rightToe})
      if (*foot) force += (*foot)->force.z();
    EXPECT_NEAR(force, 4.6071 * 9.81, 0.1) << "type " << type;
    EXPECT_EQ(readings.leftToe.has_value(), type == 4);
    EXPECT_NEAR(readings.acc.norm(), 9.81, 1e-9) << "asleep";
    EXPECT_EQ(readings.gyro, Vec3(Vec3::Zero()));
  }
}

TEST(SoccerWorld, accelerometerIsOneCycleLate) {
  const auto world = makeWorld();
  const RobotHandle robot = world->addRobot(simsparkRobot(0), translation(0, 5, 3));
  EXPECT_EQ(world->readings(robot).acc, Vec3(Vec3::Zero()));
  world->step();
  EXPECT_NEAR(world->readings(robot).acc.z(), 9.81, 1e-9) << "it fell already, but that is not measured yet";
  world->step();
  EXPECT_NEAR(world->readings(robot).acc.z(), 0, 0.01);
}

TEST(SoccerWorld, speedIsClampedAndKept) {
  const auto world = makeWorld();
  const RobotModel model = simsparkRobot(2);
  const RobotHandle robot = world->addRobot(model, translation(0, 5, 0.385));
  run(*world, 30);
  world->setJointVelocity(robot, headYaw, 100);
  world->setJointVelocity(robot, rShoulderPitch, 0.5);
  run(*world, 4);
  EXPECT_NEAR(toDegrees(world->readings(robot).angle[headYaw]), 4 * 7.0266, 0.002)
      << "ODE turns by 2 atan(speed / 2 * step) in a step";
  EXPECT_NEAR(world->readings(robot).angle[rShoulderPitch], 0.04, 1e-3);
}

TEST(SoccerWorld, atAStopCommandsAreIgnoredAndItBouncesByASwitch) {
  for (const bool bouncing : {true, false}) {
    WorldConfig config;
    config.bouncingJointStops = bouncing;
    const auto world = makeWorld(config);
    const RobotHandle robot = world->addRobot(simsparkRobot(0), translation(0, 5, 0.385));
    JointArray angles{};
    angles[headYaw] = fromDegrees(119);
    world->setPosture(robot, angles);
    double previous = 0, most = 0, least = 200;
    int ignored = 0;
    for (int i = 0; i < 40; ++i) {
      const double angle = toDegrees(world->readings(robot).angle[headYaw]);
      if (angle >= 120) {
        world->setJointVelocity(robot, headYaw, -6);  // must not act: the motor goes on pushing
        ++ignored;
      } else {
        world->setJointVelocity(robot, headYaw, 6.2);
      }
      world->step();
      previous = toDegrees(world->readings(robot).angle[headYaw]);
      if (i < 3) continue;
      most = std::max(most, previous);
      least = std::min(least, previous);
    }
    EXPECT_GT(ignored, 0);
    if (bouncing) {
      EXPECT_NEAR(most, 126.5, 0.6);
      EXPECT_NEAR(least, 119.5, 0.6);
    } else {
      EXPECT_LT(most - least, 2) << most << " " << least;
    }
  }
}

TEST(SoccerWorld, aSleeperHangsInTheAirUntilACommandThatIsNotZero) {
  const auto world = makeWorld();
  const RobotHandle robot = world->addRobot(simsparkRobot(0), translation(0, 5, 0.385));
  run(*world, 60);
  world->moveRobot(robot, translation(-3, 2, 0.4) * rotationZ(1));
  run(*world, 20);
  EXPECT_EQ(height(*world, robot), 0.4);
  EXPECT_FALSE(world->readings(robot).leftFoot.has_value());
  world->setJointVelocity(robot, headYaw, 0);
  run(*world, 5);
  EXPECT_EQ(height(*world, robot), 0.4);
  world->setJointVelocity(robot, headYaw, 1e-7);
  run(*world, 20);
  EXPECT_NEAR(height(*world, robot), 0.38387, 1e-4);
}

TEST(SoccerWorld, insomniacsFall) {
  WorldConfig config;
  config.sleepingRobots = false;
  const auto world = makeWorld(config);
  const RobotHandle robot = world->addRobot(simsparkRobot(0), translation(0, 5, 0.385));
  run(*world, 60);
  world->moveRobot(robot, translation(-3, 2, 0.4));
  run(*world, 20);
  EXPECT_NEAR(height(*world, robot), 0.38387, 1e-4);
}

TEST(SoccerWorld, aSleepersFeetKeepTheirReading) {
  const auto world = makeWorld();
  const RobotHandle robot = world->addRobot(simsparkRobot(0), translation(0, 5, 0.385));
  run(*world, 60);
  ASSERT_TRUE(world->readings(robot).leftFoot.has_value());
  EXPECT_NEAR(world->readings(robot).leftFoot->force.z(), 22.6, 0.1);
  EXPECT_NEAR(world->readings(robot).leftFoot->point.z(), -0.01, 2e-3);
}

TEST(SoccerWorld, moveKeepsThePosture) {
  const auto world = makeWorld();
  const RobotHandle robot = world->addRobot(simsparkRobot(1), translation(0, 5, 0.9));
  JointArray angles{};
  angles[lKneePitch] = 1;
  angles[rShoulderPitch] = 0.5;
  world->setPosture(robot, angles);
  world->moveRobot(robot, translation(-7, 1, 0.6) * rotationZ(-2));
  EXPECT_NEAR(world->readings(robot).angle[lKneePitch], 1, 1e-9);
  world->step();
  EXPECT_NEAR(world->readings(robot).angle[lKneePitch], 1, 1e-6);
  EXPECT_NEAR(world->torso(robot).pose.translation().x(), -7, 1e-3);
  EXPECT_NEAR(world->torso(robot).linearVelocity.z(), -9.81 * 0.02, 1e-3);
}

TEST(SoccerWorld, ballRollsAndIsStoppedByGoalAndWall) {
  const auto world = makeWorld();
  world->setBall({0, 0, FieldSize().ballRadius}, {3, 0, 0});
  run(*world, 250);
  EXPECT_NEAR(world->ball().pose.translation().x(), 2.0213, 1e-4);
  EXPECT_NEAR(world->ball().pose.translation().z(), 0.04027, 1e-5);

  world->setBall({14.8, 0, 0.3},
                 {4, 0, 0});  // into the goal, against its back; faster balls pass, there as here
  double farthest = 0;
  for (int i = 0; i < 100; ++i) {
    world->step();
    farthest = std::max(farthest, world->ball().pose.translation().x());
  }
  EXPECT_GT(farthest, 15.4);
  EXPECT_LT(farthest, 15.6);

  world->setBall({14.8, 1.07, 0.3}, {8, 0, 0});  // against the right goal's left post
  run(*world, 3);
  EXPECT_LT(world->ball().linearVelocity.x(), -3);

  world->setBall({-15.3, 0, 1.2}, {0, 0, -2});  // onto the left goal's top
  run(*world, 150);
  EXPECT_GT(world->ball().pose.translation().z(), 0.8);

  world->setBall({0, 14, 0.042}, {0, 60, 0});  // a wall half a metre high
  run(*world, 200);
  EXPECT_LT(world->ball().pose.translation().y(), 24.5);
}

TEST(SoccerWorld, tellsWhoTouchedTheBall) {
  const auto world = makeWorld();
  world->addRobot(simsparkRobot(0), translation(3, 0, 0.385));
  const RobotHandle robot = world->addRobot(simsparkRobot(0), translation(-0.5, 0, 0.385));
  world->setBall({0.2, -0.055, FieldSize().ballRadius}, {-3, 0, 0});
  bool touched = false;
  for (int i = 0; i < 30; ++i) {
    world->step();
    if (world->ballTouchedBy().empty()) continue;
    EXPECT_EQ(world->ballTouchedBy(), std::vector<RobotHandle>{robot});
    touched = true;
  }
  EXPECT_TRUE(touched);
  world->setBall({0, 5, 1}, Vec3::Zero());
  world->step();
  EXPECT_TRUE(world->ballTouchedBy().empty());
}

TEST(SoccerWorld, refusesWhatMakesNoSense) {
  const auto world = makeWorld();
  EXPECT_THROW(world->readings(0), std::out_of_range);
  const RobotHandle robot = world->addRobot(simsparkRobot(0), translation(0, 0, 1));
  EXPECT_THROW(world->setJointVelocity(robot, lToePitch, 1), std::invalid_argument);
  EXPECT_THROW(world->setJointVelocity(robot, headYaw, std::numeric_limits<double>::quiet_NaN()),
               std::invalid_argument);
  EXPECT_THROW(world->setJointVelocity(robot, noJoint, 1), std::invalid_argument);
  world->removeRobot(robot);
  EXPECT_THROW(world->moveRobot(robot, Pose3::Identity()), std::out_of_range);
}

/// What a world does with two robots that move and a ball, as bytes.
std::string story(World& world) {
  const RobotHandle a = world.addRobot(simsparkRobot(0), translation(-0.5, 0, 0.4));
  const RobotHandle b = world.addRobot(simsparkRobot(4), translation(0.5, 0, 0.4) * rotationZ(pi));
  world.setBall({0, 0.05, 0.3}, {0.2, 0, 0});
  std::string bytes;
  const auto add = [&](const BodyState& state) {
    for (const double* p : {state.pose.data(), state.linearVelocity.data(), state.angularVelocity.data()})
      bytes.append(reinterpret_cast<const char*>(p), 3 * sizeof(double));
    bytes.append(reinterpret_cast<const char*>(state.pose.data() + 12), 3 * sizeof(double));
  };
  for (int i = 0; i < 150; ++i) {
    const double speed = i % 40 < 20 ? 1 : -1;
    for (const RobotHandle robot : {a, b})
      for (const JointId joint : {lHipPitch, rHipPitch, lKneePitch, rShoulderRoll, lAnklePitch})
        world.setJointVelocity(robot, joint, speed * (joint == lHipPitch ? 1.3 : 0.7));
    world.step();
    add(world.torso(a));
    add(world.torso(b));
    add(world.ball());
  }
  return bytes;
}

TEST(SoccerWorld, sameCallsSameBytes) {
  const auto world = makeWorld();
  const std::string first = story(*world);
  world->reset();
  EXPECT_EQ(story(*world), first) << "after a reset";
  EXPECT_EQ(story(*makeWorld()), first) << "in a world of its own";
}

TEST(SoccerWorld, worldsInThreadsDoNotDisturbEachOther) {
  const std::string alone = story(*makeWorld());
  std::string stories[3];
  const auto movedWorld = makeWorld();  // made here, used there
  std::thread threads[3] = {std::thread([&] { stories[0] = story(*makeWorld()); }),
                            std::thread([&] { stories[1] = story(*makeWorld()); }),
                            std::thread([&] { stories[2] = story(*movedWorld); })};
  for (std::thread& thread : threads) thread.join();
  for (const std::string& each : stories) EXPECT_EQ(each, alone);
}

TEST(SoccerWorld, aRemovedRobotLeavesNothingBehind) {
  const auto world = makeWorld();
  const RobotHandle robot = world->addRobot(simsparkRobot(0), translation(0, 0, 0.385));
  run(*world, 5);
  world->removeRobot(robot);
  world->setBall({-0.5, 0, FieldSize().ballRadius}, {3, 0, 0});
  run(*world, 250);
  EXPECT_NEAR(world->ball().pose.translation().x(), 1.5213, 1e-3) << "nobody in its way";
  EXPECT_THROW(world->torso(robot), std::out_of_range);
}

/// What a pile of eleven came to: a foot presses a toe past its stop, where its motor lets go, and beyond the
/// other one within a step. Its drag alone then made it twenty times faster in each step.
TEST(SoccerWorld, aToeThatIsSpunPastItsStopsGetsNoFaster) {
  for (const char* engine : {"ode", "ode-dense", "bullet"}) {
    WorldConfig config;
    config.engine = engine;
    const auto world = makeWorld(config);
    const RobotModel& model = simsparkRobot(4);
    const RobotHandle robot = world->addRobot(model, translation(0, 0, 3));
    world->setJointVelocity(robot, lToePitch, -6);  // away from the upper stop, which is at 0.017
    JointArray angles{}, rates{};
    angles[lToePitch] = 0.3;
    rates[lToePitch] = 86;
    world->setState(robot, world->torso(robot), angles, rates);
    for (int cycle = 0; cycle < 30; ++cycle) {
      ASSERT_NO_THROW(world->step()) << engine << ", cycle " << cycle;
      ASSERT_LT(world->linkState(robot, model.linkIndex("lToe")).angularVelocity.norm(), 90)
          << engine << ", cycle " << cycle;
    }
    EXPECT_NEAR(world->torso(robot).linearVelocity.z(), -5.8, 0.1) << engine << ": it falls as it did";
  }
}

}  // namespace
}  // namespace plumbline::simulation
