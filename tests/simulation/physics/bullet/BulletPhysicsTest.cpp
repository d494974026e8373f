#include "simulation/physics/bullet/BulletPhysics.h"

#include <gtest/gtest.h>

#include "math/Angle.h"
#include "simspark/LeagueRobots.h"
#include "simulation/league/MakeWorld.h"

namespace plumbline::simulation {
namespace {

WorldConfig onBullet() {
  WorldConfig config;
  config.engine = "bullet";
  return config;
}

/// Robots that kneel, turn their arms and fall over each other and the ball; all poses at the end.
std::vector<double> story(World& world) {
  std::vector<RobotHandle> robots;
  for (int i = 0; i < 3; ++i)
    robots.push_back(world.addRobot(simsparkRobot(i + 2), translation(0.25 * i, 0.1 * i, 0.45)));
  world.setBall(Vec3(-1, 0, 0.042), Vec3(4, 0.2, 0.5));
  for (int cycle = 0; cycle < 150; ++cycle) {
    for (const RobotHandle robot : robots) {
      world.setJointVelocity(robot, lKneePitch, 2 * std::sin(0.3 * cycle));
      world.setJointVelocity(robot, rHipPitch, -1.5);
      world.setJointVelocity(robot, lShoulderPitch, cycle < 60 ? 6 : -6);
    }
    world.step();
  }
  std::vector<double> all;
  for (const RobotHandle robot : robots)
    for (int link = 0; link < 10; ++link) {
      const BodyState state = world.linkState(robot, link);
      for (const double value : state.pose.matrix().reshaped()) all.push_back(value);
      for (const double value : state.angularVelocity) all.push_back(value);
    }
  const Vec3 ball = world.ball().pose.translation();
  for (const double value : ball) all.push_back(value);
  return all;
}

TEST(BulletPhysics, resetsAndFreshStartsGiveTheSameBytes) {
  const auto world = makeWorld(onBullet());
  const std::vector<double> first = story(*world);
  world->reset();
  EXPECT_EQ(story(*world), first);
  EXPECT_EQ(story(*makeWorld(onBullet())), first);
}

TEST(BulletPhysics, eachTypeStandsForTenSeconds) {
  for (int type = 0; type < numSimsparkTypes(); ++type) {
    WorldConfig config = onBullet();
    config.sleepingRobots = false;
    const auto world = makeWorld(config);
    const RobotHandle robot = world->addRobot(simsparkRobot(type), translation(0, 0, 0.4));
    for (int i = 0; i < 100; ++i) world->step();
    const Pose3 before = world->torso(robot).pose;
    for (int i = 0; i < 400; ++i) world->step();
    EXPECT_GT(world->torso(robot).pose.linear()(2, 2), 0.99999) << "type " << type;
    EXPECT_LT((world->torso(robot).pose.translation() - before.translation()).norm(), 1e-4)
        << "type " << type;
  }
}

TEST(BulletPhysics, hingesDoNotGape) {
  const auto world = makeWorld(onBullet());
  const RobotModel model = simsparkRobot(0);
  const RobotHandle robot = world->addRobot(model, translation(0, 0, 0.8) * rotationX(1));
  double widest = 0;
  for (int cycle = 0; cycle < 100; ++cycle) {
    world->setJointVelocity(robot, rHipPitch, cycle % 20 < 10 ? 6 : -6);
    world->step();
    for (std::size_t i = 1; i < model.links.size(); ++i) {
      const Link &child = model.links[i], &parent = model.links[static_cast<std::size_t>(child.parent)];
      const Vec3 below = world->linkState(robot, static_cast<int>(i)).pose * Vec3(-child.com);
      const Vec3 above = world->linkState(robot, child.parent).pose * Vec3(child.origin - parent.com);
      widest = std::max(widest, (below - above).norm());
    }
  }
  EXPECT_LT(widest, 1e-12) << "on the league's engine they do, by up to a millimetre";
}

/// A skew body and a skew limb that tumble freely.
AssemblyState tumbled(const char* engine, double step, int steps) {
  PhysicsConfig config;
  config.stepSeconds = step;
  config.gravity.setZero();
  config.surfaces = {{ContactSurface{}}};
  const auto physics = makePhysics(engine, config);
  Assembly assembly;
  assembly.bodies.resize(2);
  const Mat3 skew = (rotationX(0.4) * rotationZ(0.7)).linear();
  for (int i = 0; i < 2; ++i) {
    BodySpec& body = assembly.bodies[static_cast<std::size_t>(i)];
    body.mass = i == 0 ? 2 : 0.5;
    body.inertia = skew * Vec3(0.01, 0.02, 0.025).asDiagonal() * skew.transpose() * body.mass;
    body.T_root_body = i == 0 ? Pose3::Identity() : translation(0.1, 0.05, 0.3) * rotationY(0.5);
  }
  HingeSpec hinge;
  hinge.child = 1;
  hinge.anchor = {0.05, 0, 0.1};
  hinge.axis = Vec3(1, 2, 3).normalized();
  hinge.lower = -50;
  hinge.upper = 50;
  hinge.maxTorque = 0;
  assembly.hinges = {hinge};
  const int handle = physics->addAssembly(assembly, Pose3::Identity());
  AssemblyState state = physics->state(handle);
  state.root.linearVelocity = {0.3, -0.2, 0.1};
  state.root.angularVelocity = {1, 2, -0.5};
  state.angle = {0.3};
  state.rate = {-1.5};
  physics->setState(handle, state);
  for (int i = 0; i < steps; ++i) physics->step();
  return physics->state(handle);
}

TEST(BulletPhysics, agreesWithOdeWhereStepsAreSmall) {
  const AssemblyState ode = tumbled("ode", 1e-4, 5000), bullet = tumbled("bullet", 1e-4, 5000);
  EXPECT_NEAR(bullet.angle[0], ode.angle[0], 1e-3);
  EXPECT_NEAR(bullet.rate[0], ode.rate[0], 2e-3);
  EXPECT_TRUE(bullet.root.pose.isApprox(ode.root.pose, 1e-3)) << bullet.root.pose.matrix() << "\n\n"
                                                              << ode.root.pose.matrix();
  EXPECT_TRUE(bullet.root.angularVelocity.isApprox(ode.root.angularVelocity, 2e-3));
}

}  // namespace
}  // namespace plumbline::simulation
