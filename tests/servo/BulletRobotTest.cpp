#include "servo/BulletRobot.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <stdexcept>

#include "math/Angle.h"
#include "robot/MechanismFile.h"

namespace plumbline::servo {
namespace {

std::size_t at(int i) { return static_cast<std::size_t>(i); }

Mechanism nao() { return findMechanism("nao_v5"); }

/// A posture of the NAO that stands.
std::vector<double> bent(const Mechanism& robot) {
  std::vector<double> q(at(robot.numJoints()), 0);
  for (const std::string side : {"L", "R"}) {
    q[at(robot.jointIndex(side + "HipPitch"))] = -0.5;
    q[at(robot.jointIndex(side + "KneePitch"))] = 1.0;
    q[at(robot.jointIndex(side + "AnklePitch"))] = -0.5;
    q[at(robot.jointIndex(side + "ShoulderPitch"))] = 1.5;
  }
  return q;
}

/// A rod of 0.2 kg, 0.4 m long, on a hinge about y, hanging down at zero.
Mechanism pendulum() {
  Mechanism robot;
  robot.name = "pendulum";
  robot.links.resize(2);
  robot.links[0].name = "base";
  robot.links[0].mass = 1;
  robot.links[0].inertia = Mat3::Identity() * 0.01;
  robot.links[1].name = "rod";
  robot.links[1].parent = 0;
  robot.links[1].mass = 0.2;
  robot.links[1].com = {0, 0, -0.2};
  robot.links[1].inertia = Vec3(1, 1, 0.01).asDiagonal() * (0.2 * 0.4 * 0.4 / 12);
  Mechanism::Joint joint;
  joint.name = "hinge";
  joint.child = 1;
  joint.axis = Vec3::UnitY();
  joint.lower = -3;
  joint.upper = 3;
  joint.maxTorque = 1;
  joint.maxSpeed = 100;
  robot.joints = {joint};
  return robot;
}
constexpr double rodInertia = 0.2 * 0.4 * 0.4 / 3;  ///< about the hinge

BulletRobot onFixedBase(const Mechanism& robot, double step = 0.002) {
  RobotSimulationOptions config;
  config.fixedBase = true;
  config.stepSeconds = step;
  return BulletRobot(robot, config);
}

TEST(BulletRobot, theNaoStandsAndItsSensorsSaySo) {
  const Mechanism robot = nao();
  BulletRobot world(robot);
  world.restart(bent(robot));
  for (int i = 0; i < 300; ++i) {
    world.command(bent(robot));
    world.step();
  }
  const ServoReadings& r = world.readings();
  EXPECT_NEAR(r.time, 3, 1e-9);
  EXPECT_GT(world.base().pose.linear()(2, 2), 0.999);
  EXPECT_NEAR(world.base().pose.translation().z(), 0.307, 0.002);
  EXPECT_LT(r.gyro.norm(), 0.02);
  EXPECT_NEAR(r.acc.z(), 9.81, 0.02);
  double weight = 0;
  for (const auto& foot : r.footForce) {
    ASSERT_EQ(foot.size(), 4u);
    for (const double force : foot) weight += force;
  }
  EXPECT_NEAR(weight, robot.totalMass() * 9.81, 0.3);
  const int knee = robot.jointIndex("LKneePitch");
  const Servo& servo = robot.joints[at(knee)].servo;
  EXPECT_NEAR(r.torque[at(knee)], servo.kp * (1 - r.position[at(knee)]), 0.02)
      << "the servo's own law at rest";
  EXPECT_GT(std::abs(r.torque[at(knee)]), 0.3);
}

TEST(BulletRobot, aPushMovesItAndALargeOneFellsIt) {
  const Mechanism robot = nao();
  const auto tilt = [&robot](double newton) {
    BulletRobot world(robot);
    world.restart(bent(robot));
    double least = 1;
    for (int i = 0; i < 300; ++i) {
      if (i == 50) world.push({0, newton, 0}, 0.1);
      world.command(bent(robot));
      world.step();
      least = std::min(least, world.base().pose.linear()(2, 2));
    }
    return least;
  };
  EXPECT_GT(tilt(0), 0.999);
  EXPECT_GT(tilt(15), 0.98);
  EXPECT_LT(tilt(15), 0.9995);
  EXPECT_LT(tilt(80), 0.5);
}

TEST(BulletRobot, liesOnTheGroundWhenItHasFallen) {
  const Mechanism robot = nao();
  BulletRobot world(robot);
  world.restart(translation(0, 0, 0.6) * rotationX(1), bent(robot));
  for (int i = 0; i < 200; ++i) world.step();
  EXPECT_GT(world.base().pose.translation().z(), 0.0);
  EXPECT_LT(world.base().pose.translation().z(), 0.2);
  for (const double q : world.readings().position) EXPECT_TRUE(std::isfinite(q));
}

TEST(BulletRobot, theSameCallsGiveTheSameBytes) {
  const Mechanism robot = nao();
  const auto story = [&robot](BulletRobot& world) {
    world.restart(bent(robot), 0.3);
    std::vector<double> q = bent(robot);
    for (int i = 0; i < 100; ++i) {
      q[at(robot.jointIndex("LHipRoll"))] = 0.2 * std::sin(0.2 * i);
      if (i == 30) world.push({10, 5, 0}, 0.05);
      world.command(q);
      world.step();
    }
    std::vector<double> all = world.readings().position;
    for (const double value : world.base().pose.matrix().reshaped()) all.push_back(value);
    for (const double value : world.readings().acc) all.push_back(value);
    return all;
  };
  BulletRobot world(robot);
  const auto first = story(world);
  EXPECT_EQ(story(world), first);
  BulletRobot fresh(robot);
  EXPECT_EQ(story(fresh), first);
}

TEST(BulletRobot, anUndrivenRodSwingsAsAPendulum) {
  Mechanism robot = pendulum();
  BulletRobot world = onFixedBase(robot, 1e-4);
  world.restart(Pose3::Identity(), {0.02});
  world.setStiffness(0);
  for (int i = 0; i < 1000; ++i) world.step();
  const double omega = std::sqrt(0.2 * 9.81 * 0.2 / rodInertia);
  EXPECT_NEAR(world.readings().position[0], 0.02 * std::cos(omega * 10), 2e-4);
}

TEST(BulletRobot, armatureAddsToTheJointsInertia) {
  Mechanism robot = pendulum();
  robot.gravity.setZero();
  robot.joints[0].servo.kp = 1;
  robot.joints[0].servo.armature = 0.05;
  BulletRobot world = onFixedBase(robot, 1e-4);
  world.restart(Pose3::Identity(), {0.1});
  world.command({0});
  for (int i = 0; i < 100; ++i) world.step();
  const double omega = std::sqrt(1 / (rodInertia + 0.05));
  EXPECT_NEAR(world.readings().position[0], 0.1 * std::cos(omega), 1e-4);
}

TEST(BulletRobot, torqueHasItsLimitAndFadesNearTheTopSpeed) {
  Mechanism robot = pendulum();
  robot.gravity.setZero();
  robot.joints[0].upper = 1000;
  robot.joints[0].maxTorque = 0.05;
  robot.joints[0].maxSpeed = 2;
  robot.joints[0].servo.kp = 1000;
  BulletRobot world = onFixedBase(robot);
  world.restart(Pose3::Identity(), {0});
  world.command({500});
  world.step();
  EXPECT_NEAR(world.readings().torque[0], 0.05, 1e-12);
  EXPECT_NEAR(world.readings().velocity[0], 0.05 / rodInertia * 0.01, 1e-6);
  world.setStiffness(0, 0.5);
  world.step();
  EXPECT_NEAR(world.readings().torque[0], 0.025, 1e-12);
  world.setStiffness(1);
  for (int i = 0; i < 300; ++i) world.step();
  EXPECT_NEAR(world.readings().velocity[0], 2, 0.03);
  EXPECT_LT(world.readings().torque[0], 0.005);
}

TEST(BulletRobot, aDcMotorTurnsAsFastAsItsVoltageLets) {
  Mechanism robot = pendulum();
  robot.gravity.setZero();
  robot.joints[0].upper = 1000;
  Servo& servo = robot.joints[0].servo;
  servo.model = Servo::Model::dcMotor;
  servo.kt = 0.3;
  servo.R = 2;
  servo.vin = 6;
  servo.errorGain = 0.1;
  servo.kpFirmware = 10;
  servo.maxPwm = 0.5;
  servo.kp = servo.kt * servo.vin * servo.errorGain * servo.kpFirmware / servo.R;
  servo.kd = servo.kt * servo.kt / servo.R;
  robot.joints[0].maxTorque = 10;
  BulletRobot world = onFixedBase(robot);
  world.restart(Pose3::Identity(), {0});
  world.command({900});
  for (int i = 0; i < 300; ++i) world.step();
  EXPECT_NEAR(world.readings().velocity[0], 6 * 0.5 / 0.3, 0.01) << "duty times supply by kt";
}

TEST(BulletRobot, aDrivenJointFollowsItsDriver) {
  const Mechanism robot = nao();
  const int driven = robot.jointIndex("RHipYawPitch"), driver = robot.jointIndex("LHipYawPitch");
  ASSERT_EQ(robot.joints[at(driven)].driver, driver);
  BulletRobot world = onFixedBase(robot);
  std::vector<double> q(at(robot.numJoints()), 0);
  world.restart(translation(0, 0, 1), q);
  q[at(driver)] = -0.5;
  for (int i = 0; i < 100; ++i) {
    world.command(q);
    world.step();
    EXPECT_NEAR(world.readings().position[at(driven)], world.readings().position[at(driver)], 1e-3);
  }
  EXPECT_NEAR(world.readings().position[at(driver)], -0.5, 0.05);
}

TEST(BulletRobot, commandsShowInTheNextCycle) {
  Mechanism robot = pendulum();
  robot.joints[0].servo.kp = 50;
  robot.joints[0].servo.kd = 1;
  BulletRobot world = onFixedBase(robot);
  world.restart(Pose3::Identity(), {0});
  world.command({0.3});
  EXPECT_EQ(world.readings().position[0], 0) << "what is read at the start of the cycle";
  world.step();
  EXPECT_GT(world.readings().position[0], 0.001);
}

TEST(BulletRobot, stopsHoldAndAnyRobotRuns) {
  Mechanism robot = pendulum();
  robot.joints[0].upper = 0.2;
  robot.joints[0].servo.kp = 50;
  robot.joints[0].servo.kd = 1;
  BulletRobot world = onFixedBase(robot);
  world.restart(Pose3::Identity(), {0});
  world.command({1});
  for (int i = 0; i < 100; ++i) world.step();
  EXPECT_NEAR(world.readings().position[0], 0.2, 0.01);
  for (const char* name : {"so101", "xl330_pendulum"}) {
    const Mechanism other = findMechanism(name);
    BulletRobot bench = onFixedBase(other);
    std::vector<double> q(at(other.numJoints()), 0.1);
    bench.restart(translation(0, 0, 1), std::vector<double>(q.size(), 0));
    for (int i = 0; i < 300; ++i) {
      bench.command(q);
      bench.step();
    }
    EXPECT_NEAR(bench.time(), 300 / other.controlHz, 1e-9);
    for (const double position : bench.readings().position) EXPECT_NEAR(position, 0.1, 0.1) << name;
  }
}

TEST(BulletRobot, feetSlipBeyondTheirFriction) {
  const Mechanism robot = nao();
  const auto way = [&robot](double friction) {
    RobotSimulationOptions config;
    config.groundFriction = friction;
    BulletRobot world(robot, config);
    world.restart(bent(robot));
    for (int i = 0; i < 100; ++i) {
      if (i == 50) world.push({0, 8, 0}, 0.5);
      world.step();
    }
    return world.link(robot.linkIndex("l_ankle")).pose.translation().y();
  };
  EXPECT_NEAR(way(0.8), way(0.7), 0.002);
  EXPECT_GT(way(0.05), way(0.8) + 0.05);
}

TEST(BulletRobot, refusesWhatMakesNoSense) {
  const Mechanism robot = pendulum();
  RobotSimulationOptions config;
  config.stepSeconds = 0;
  EXPECT_THROW(BulletRobot(robot, config), std::invalid_argument);
  BulletRobot world = onFixedBase(robot);
  try {
    world.command({1, 2});
    FAIL();
  } catch (const std::invalid_argument& error) {
    EXPECT_STREQ(error.what(), "Bullet robot: 2 targets for 1 joints");
  }
  EXPECT_THROW(world.command({std::nan("")}), std::invalid_argument);
  EXPECT_THROW(world.restart(Pose3::Identity(), {}), std::invalid_argument);
  EXPECT_THROW(world.setStiffness(5, 1), std::out_of_range);
  EXPECT_THROW(world.push({1, 0, 0}, 1, 9), std::out_of_range);
}

/// The rod held at its base with a servo of kp 5, kd 0.1, armature 0.001, and what `change` does to its
/// drive; after 3 s at that command.
BulletRobot rested(double target, const std::function<void(JointPlant&)>& change) {
  Mechanism robot = pendulum();
  robot.joints[0].servo.kp = 5;
  robot.joints[0].servo.kd = 0.1;
  robot.joints[0].servo.armature = 0.001;
  RobotSimulationOptions config;
  config.fixedBase = true;
  config.stepSeconds = 0.0005;
  config.drives = {JointPlant::nominal(robot.joints[0])};
  change(config.drives[0]);
  BulletRobot world(robot, config);
  for (int i = 0; i < 800; ++i) {
    world.command({target * std::min(1.0, i / 200.0)});
    world.step();
  }
  return world;
}

/// Of the rod's weight about the hinge.
double weight(double q) { return 0.2 * 9.81 * 0.2 * std::sin(q); }

TEST(BulletRobot, aDrivesFrictionHoldsWhatItCan) {
  // 5 (0.06 - q) = weight(q) without friction: at 0.0556 rad. With it the joint sticks where it started.
  EXPECT_NEAR(rested(0.06, [](JointPlant&) {}).readings().position[0], 0.0556, 2e-4);
  EXPECT_NEAR(rested(0.06, [](JointPlant& d) { d.coulomb = 0.31; }).readings().position[0], 0, 1e-4);
  const double q = rested(0.3, [](JointPlant& d) { d.coulomb = 0.31; }).readings().position[0];
  EXPECT_NEAR(5 * (0.3 - q) - weight(q), 0.295, 0.016)
      << "it stops where the rest is as large as the friction, less what the rod's swing takes it on";
}

TEST(BulletRobot, aSoftGearGivesWayBehindItsEncoder) {
  const BulletRobot world = rested(0.5, [](JointPlant& d) { d.compliance = 0.2; });
  const double link = world.readings().position[0], motor = world.encoder(0);
  EXPECT_NEAR(motor - link, 0.2 * weight(link), 1e-4);
  EXPECT_NEAR(5 * (0.5 - motor), weight(link), 1e-4);
}

TEST(BulletRobot, playLetsTheLinkHangAtItsEnd) {
  const auto play = [](JointPlant& d) { d.backlash = 0.1; };
  const BulletRobot up = rested(0.5, play), down = rested(-0.5, play);
  EXPECT_NEAR(up.encoder(0) - up.readings().position[0], 0.05, 5e-4);
  EXPECT_NEAR(down.encoder(0) - down.readings().position[0], -0.05, 5e-4);
  const BulletRobot seen = rested(0.5, [&](JointPlant& d) {
    play(d);
    d.linkEncoder = true;
  });
  EXPECT_DOUBLE_EQ(seen.encoder(0), seen.readings().position[0]);
}

TEST(BulletRobot, drivesBrakePushAndAreLoaded) {
  EXPECT_NEAR(rested(0, [](JointPlant& d) { d.biasForce = 0.2; }).readings().position[0], 0.2 / (5 + 0.3924),
              1e-4);
  const auto steady = [](JointPlant& d) { d.torques = {[](double, double) { return 0.2; }}; };
  EXPECT_EQ(rested(0, steady).readings().position[0],
            rested(0, [](JointPlant& d) { d.biasForce = 0.2; }).readings().position[0]);
  BulletRobot loaded = rested(0, [](JointPlant&) {});
  loaded.load(0, -0.2);
  for (int i = 0; i < 300; ++i) loaded.step();
  EXPECT_NEAR(loaded.readings().position[0], -0.2 / (5 + 0.3924), 1e-4);
  // Without a servo the rod swings about the hinge by I q'' = -c q' - m g l q, with I of rod and rotor.
  const double c = 0.01;
  BulletRobot swinging = rested(0, [c](JointPlant& d) {
    d.servo.kp = d.servo.kd = 0;
    d.viscous = c;
  });
  const double start = 0.05, inertia = rodInertia + 0.001;
  swinging.restart(Pose3::Identity(), {start});
  const double rate = c / (2 * inertia), w = std::sqrt(0.2 * 9.81 * 0.2 / inertia - rate * rate);
  for (int i = 0; i < 100; ++i) swinging.step();
  EXPECT_NEAR(swinging.readings().position[0],
              start * std::exp(-rate) * (std::cos(w) + rate / w * std::sin(w)), 2e-4);
}

TEST(BulletRobot, wantsADriveForEveryJoint) {
  RobotSimulationOptions config;
  config.drives.resize(3);
  try {
    const BulletRobot world(pendulum(), config);
    ADD_FAILURE() << "it took 3 drives for 1 joint";
  } catch (const std::invalid_argument& error) {
    EXPECT_STREQ(error.what(), "Bullet robot: 3 drives for 1 joints");
  }
}

}  // namespace
}  // namespace plumbline::servo
