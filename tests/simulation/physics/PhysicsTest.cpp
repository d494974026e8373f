#include "simulation/physics/Physics.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "math/Angle.h"

namespace plumbline::simulation {
namespace {

/// What every engine must do; the league's numbers are held elsewhere.
class Engine : public testing::TestWithParam<std::string> {
protected:
  static PhysicsConfig config() {
    PhysicsConfig config;
    config.surfaces = {{{0.4, 1e-4, 0.005, 0, 0}, {0.4, 1e-4, 0.005, 0.5, 0.1}},
                       {{0.4, 1e-4, 0.005, 0.5, 0.1}, {0.4, 1e-4, 0.005, 0, 0}}};
    return config;
  }

  static BodySpec box(double mass, const Vec3& size, Material material = 0) {
    BodySpec body;
    body.mass = mass;
    const Vec3 q = size.cwiseAbs2();
    body.inertia = (mass / 12 * Vec3(q.y() + q.z(), q.x() + q.z(), q.x() + q.y())).asDiagonal();
    body.shape = Shape{Shape::Kind::box, size, Pose3::Identity()};
    body.material = material;
    return body;
  }

  /// A heavy base and a light arm 0.2 m long on a hinge about y at the base's top.
  static Assembly arm() {
    Assembly assembly;
    assembly.bodies = {box(20, {0.5, 0.5, 0.1}), box(0.2, {0.04, 0.04, 0.2})};
    assembly.bodies[1].T_root_body = translation(0, 0, 0.2);
    HingeSpec hinge;
    hinge.child = 1;
    hinge.anchor = {0, 0, 0.1};
    hinge.axis = Vec3::UnitY();
    hinge.lower = -1;
    hinge.upper = 0.5;
    assembly.hinges = {hinge};
    return assembly;
  }

  std::unique_ptr<Physics> engine = makePhysics(GetParam(), config());

  void steps(int count) {
    for (int i = 0; i < count; ++i) engine->step();
  }
};

TEST_P(Engine, fallsFreely) {
  const int box1 = engine->addAssembly({{box(1, {0.1, 0.1, 0.1})}, {}, false}, translation(0, 0, 100));
  steps(50);
  EXPECT_NEAR(engine->bodyState(box1, 0).linearVelocity.z(), -9.81, 1e-9);
  EXPECT_NEAR(engine->bodyState(box1, 0).pose.translation().z(), 100 - 9.81 * 0.02 * 0.02 * 50 * 51 / 2,
              1e-9);
}

TEST_P(Engine, aBoxRestsOnTheGroundAndItsContactsCarryIt) {
  PhysicsConfig awake = config();
  awake.autoDisable = false;
  engine = makePhysics(GetParam(), awake);
  engine->addGround(0);
  const int box1 = engine->addAssembly({{box(2, {0.2, 0.2, 0.1})}, {}, false}, translation(0, 0, 0.06));
  steps(20);
  EXPECT_NEAR(engine->bodyState(box1, 0).pose.translation().z(), 0.05, 0.002);
  Vec3 force = Vec3::Zero();
  ASSERT_EQ(engine->contacts().size(), 4u);
  for (const Contact& contact : engine->contacts()) {
    EXPECT_EQ(contact.assemblyA, box1);
    EXPECT_EQ(contact.assemblyB, -1);
    EXPECT_NEAR(contact.point.z(), -0.001, 0.002);
    force += contact.forceOnA;
  }
  EXPECT_NEAR(force.z(), 2 * 9.81, 0.2);
  EXPECT_NEAR(force.head<2>().norm(), 0, 0.02);
}

TEST_P(Engine, sleepsAtRestAndWakesOnRequest) {
  engine->addGround(0);
  const int box1 = engine->addAssembly({{box(2, {0.2, 0.2, 0.1})}, {}, false}, translation(0, 0, 0.05));
  steps(60);
  EXPECT_TRUE(engine->asleep(box1));
  engine->moveRigidly(box1, translation(0, 0, 1));
  steps(10);
  EXPECT_EQ(engine->bodyState(box1, 0).pose.translation().z(), 1) << "a move wakes nothing";
  engine->wake(box1, 0);
  steps(10);
  EXPECT_LT(engine->bodyState(box1, 0).pose.translation().z(), 0.9);
}

TEST_P(Engine, doesNotSleepIfSet) {
  PhysicsConfig awake = config();
  awake.autoDisable = false;
  const auto physics = makePhysics(GetParam(), awake);
  physics->addGround(0);
  const int box1 = physics->addAssembly({{box(2, {0.2, 0.2, 0.1})}, {}, false}, translation(0, 0, 0.05));
  for (int i = 0; i < 60; ++i) physics->step();
  EXPECT_FALSE(physics->asleep(box1));
}

TEST_P(Engine, motorTurnsTheChildByTheRightHandRule) {
  engine->addGround(0);
  const int robot = engine->addAssembly(arm(), translation(0, 0, 0.05));
  engine->setMotor(robot, 0, 0.5);
  steps(25);
  EXPECT_NEAR(engine->hingeAngle(robot, 0), 0.25, 1e-3);
  EXPECT_GT(engine->bodyState(robot, 1).pose.translation().x(), 0.02) << "about y: from up to forward";
  EXPECT_NEAR(engine->state(robot).rate[0], 0.5, 1e-3);
}

TEST_P(Engine, stopsHold) {
  engine->addGround(0);
  const int robot = engine->addAssembly(arm(), translation(0, 0, 0.05));
  engine->setMotor(robot, 0, 1);
  double largest = 0;
  for (int i = 0; i < 100; ++i) {
    engine->step();
    largest = std::max(largest, engine->hingeAngle(robot, 0));
  }
  EXPECT_NEAR(largest, 0.5, 0.03);
  engine->setMotor(robot, 0, -1);
  engine->wake(robot, 1);
  steps(150);
  EXPECT_NEAR(engine->hingeAngle(robot, 0), -1, 0.03);
}

TEST_P(Engine, aWeakMotorYields) {
  Assembly weak = arm();
  weak.hinges[0].maxTorque = 0.01;  // the arm at 0.4 rad weighs 0.076 N m
  engine->addGround(0);
  const int robot = engine->addAssembly(weak, translation(0, 0, 0.05));
  AssemblyState state = engine->state(robot);
  state.angle[0] = -0.4;
  engine->setState(robot, state);
  steps(50);
  EXPECT_NEAR(engine->hingeAngle(robot, 0), -1, 0.05) << "it falls to its stop";
}

TEST_P(Engine, setStatePlacesEverything) {
  const int robot = engine->addAssembly(arm(), translation(0, 0, 5));
  AssemblyState state;
  state.root.pose = translation(1, 2, 3) * rotationZ(pi / 2);
  state.root.linearVelocity = {0.1, 0, 0};
  state.root.angularVelocity = {0, 0, 2};
  state.angle = {-0.5};
  state.rate = {0.25};
  engine->setState(robot, state);
  EXPECT_NEAR(engine->hingeAngle(robot, 0), -0.5, 1e-12);
  const BodyState child = engine->bodyState(robot, 1);
  // 0.1 m above the base's centre the arm leans back by 0.5 rad; the base looks along y.
  EXPECT_TRUE(
      child.pose.translation().isApprox(Vec3(1, 2 - 0.1 * std::sin(0.5), 3.1 + 0.1 * std::cos(0.5)), 1e-12));
  EXPECT_TRUE(child.angularVelocity.isApprox(Vec3(-0.25, 0, 2), 1e-12));
  const Vec3 arm = child.pose.translation() - Vec3(1, 2, 3.1);
  EXPECT_TRUE(child.linearVelocity.isApprox(Vec3(0.1, 0, 0) + Vec3(-0.25, 0, 2).cross(arm), 1e-12));
  const AssemblyState again = engine->state(robot);
  EXPECT_TRUE(again.root.pose.isApprox(state.root.pose, 1e-12));
  EXPECT_NEAR(again.rate[0], 0.25, 1e-12);
}

TEST_P(Engine, movesRigidlyAndStops) {
  const int robot = engine->addAssembly(arm(), translation(0, 0, 5));
  engine->setMotor(robot, 0, -1);
  steps(20);
  const double angle = engine->hingeAngle(robot, 0);
  engine->moveRigidly(robot, translation(3, 0, 1));
  EXPECT_NEAR(engine->hingeAngle(robot, 0), angle, 1e-12);
  EXPECT_TRUE(engine->bodyState(robot, 0).pose.translation().isApprox(Vec3(3, 0, 1), 1e-12));
  EXPECT_EQ(engine->bodyState(robot, 1).linearVelocity.norm(), 0);
}

TEST_P(Engine, assembliesTouchAndTheirOwnBodiesDoNot) {
  engine->addGround(0);
  const int below = engine->addAssembly({{box(2, {0.4, 0.4, 0.2})}, {}, false}, translation(0, 0, 0.1));
  const int above = engine->addAssembly({{box(1, {0.1, 0.1, 0.1})}, {}, false}, translation(0, 0, 0.26));
  steps(40);
  EXPECT_NEAR(engine->bodyState(above, 0).pose.translation().z(), 0.25, 0.004);
  bool touch = false;
  for (const Contact& c : engine->contacts()) touch = touch || (c.assemblyA == below && c.assemblyB == above);
  EXPECT_TRUE(touch);
  engine->removeAssembly(below);
  engine->wake(above, 0);
  steps(60);
  EXPECT_NEAR(engine->bodyState(above, 0).pose.translation().z(), 0.05, 0.004);
}

/// Two boxes joined at a distance, their parent in between without a collider.
Assembly folded(bool selfCollision, const BodySpec& box) {
  Assembly assembly;
  assembly.selfCollision = selfCollision;
  assembly.bodies = {box, box, box};
  for (int i = 1; i <= 2; ++i) {
    HingeSpec hinge;
    hinge.child = i;
    hinge.parent = i - 1;
    hinge.lower = -3;
    hinge.upper = 3;
    hinge.axis = Vec3::UnitY();
    hinge.anchor = {0.2 * i - 0.1, 0, 0};
    assembly.bodies[static_cast<std::size_t>(i)].T_root_body = translation(0.2 * i, 0, 0);
    assembly.hinges.push_back(hinge);
  }
  return assembly;
}

TEST_P(Engine, selfCollisionIsASwitch) {
  for (const bool on : {false, true}) {
    const auto physics = makePhysics(GetParam(), config());
    const int snake = physics->addAssembly(folded(on, box(1, {0.18, 0.1, 0.25})), translation(0, 0, 50));
    AssemblyState state = physics->state(snake);
    state.angle = {1.5, 1.5};  // first and third now lie side by side, neighbours touch
    physics->setState(snake, state);
    physics->step();
    EXPECT_EQ(physics->contacts().empty(), !on);
    for (const Contact& c : physics->contacts()) EXPECT_EQ(c.bodyB - c.bodyA, 2) << "neighbours never touch";
  }
}

TEST_P(Engine, bouncesByTheMaterials) {
  engine->addGround(1);
  const int soft = engine->addAssembly({{box(1, {0.1, 0.1, 0.1}, 0)}, {}, false}, translation(0, 0, 1));
  const int dull = engine->addAssembly({{box(1, {0.1, 0.1, 0.1}, 1)}, {}, false}, translation(3, 0, 1));
  double highestSoft = 0, highestDull = 0;
  for (int i = 0; i < 60; ++i) {
    engine->step();
    if (i < 25) continue;
    highestSoft = std::max(highestSoft, engine->bodyState(soft, 0).pose.translation().z());
    highestDull = std::max(highestDull, engine->bodyState(dull, 0).pose.translation().z());
  }
  EXPECT_NEAR(highestSoft, 0.05 + 0.25 * 0.95, 0.08) << "half the speed, a quarter of the height";
  EXPECT_LT(highestDull, 0.12);
}

TEST_P(Engine, frictionHasALimitOnlyIfSet) {
  for (const double coefficient : {std::numeric_limits<double>::infinity(), 0.3}) {
    PhysicsConfig rough = config();
    for (auto& row : rough.surfaces)
      for (ContactSurface& surface : row) {
        surface.slip = 1e-3;
        surface.friction = coefficient;
      }
    const auto physics = makePhysics(GetParam(), rough);
    physics->addGround(0);
    const int box1 = physics->addAssembly({{box(2, {0.4, 0.4, 0.1})}, {}, false}, translation(0, 0, 0.0489));
    for (int i = 0; i < 5; ++i) physics->step();
    AssemblyState state = physics->state(box1);
    state.root.linearVelocity = {1, 0, 0};
    physics->setState(box1, state);
    for (int i = 0; i < 10; ++i) physics->step();
    const double speed = physics->bodyState(box1, 0).linearVelocity.x();
    if (std::isfinite(coefficient))
      EXPECT_NEAR(speed, 1 - 0.3 * 9.81 * 0.2, 0.02);
    else
      EXPECT_NEAR(speed, 0, 1e-3);
  }
}

TEST_P(Engine, dragSlows) {
  Assembly ball{{box(1, {0.1, 0.1, 0.1})}, {}, false};
  ball.bodies[0].linearDrag = 0.5;
  ball.bodies[0].angularDrag = 1e-3;
  const int handle = engine->addAssembly(ball, translation(0, 0, 1000));
  AssemblyState state = engine->state(handle);
  state.root.linearVelocity = {10, 0, 0};
  state.root.angularVelocity = {0, 0, 1};
  engine->setState(handle, state);
  engine->step();
  EXPECT_NEAR(engine->bodyState(handle, 0).linearVelocity.x(), 10 - 10 * 0.5 * 0.02, 1e-9);
  EXPECT_NEAR(engine->bodyState(handle, 0).angularVelocity.z(), 1 - 1e-3 * 0.02 / (0.01 / 6), 1e-9);
}

TEST_P(Engine, staticsStand) {
  engine->addStatic({Shape::Kind::box, {1, 1, 1}, Pose3::Identity()}, translation(0, 0, 2) * rotationZ(0.3),
                    0);
  const int box1 = engine->addAssembly({{box(1, {0.1, 0.1, 0.1})}, {}, false}, translation(0.2, 0, 2.56));
  const int box2 = engine->addAssembly({{box(1, {0.1, 0.1, 0.1})}, {}, false}, translation(3, 0, 2.56));
  steps(30);
  EXPECT_NEAR(engine->bodyState(box1, 0).pose.translation().z(), 2.55, 0.004);
  EXPECT_LT(engine->bodyState(box2, 0).pose.translation().z(), 1);
}

TEST_P(Engine, refusesWhatMakesNoSense) {
  EXPECT_THROW(engine->bodyState(7, 0), std::out_of_range);
  EXPECT_THROW(engine->removeAssembly(0), std::out_of_range);
  EXPECT_THROW(engine->addAssembly({}, Pose3::Identity()), std::invalid_argument);
  Assembly loop = arm();
  loop.hinges.push_back(loop.hinges[0]);
  EXPECT_THROW(engine->addAssembly(loop, Pose3::Identity()), std::invalid_argument);
  Assembly flat = arm();
  flat.bodies[0].shape->size.z() = 0;
  EXPECT_THROW(engine->addAssembly(flat, Pose3::Identity()), std::invalid_argument);
  Assembly strange = arm();
  strange.bodies[1].material = 2;
  EXPECT_THROW(engine->addAssembly(strange, Pose3::Identity()), std::invalid_argument);
  const int robot = engine->addAssembly(arm(), translation(0, 0, 5));
  EXPECT_THROW(engine->setState(robot, AssemblyState{}), std::invalid_argument);
  steps(3);  // what was refused left nothing behind
  EXPECT_NEAR(engine->bodyState(robot, 0).linearVelocity.z(), -3 * 9.81 * 0.02, 1e-9);
}

INSTANTIATE_TEST_SUITE_P(Engines, Engine, testing::ValuesIn(physicsEngines()));

TEST(Physics, unknownEngineNamesThoseThereAre) {
  try {
    makePhysics("havok", {});
    FAIL();
  } catch (const std::invalid_argument& error) {
    EXPECT_STREQ(error.what(), "unknown physics engine \"havok\"; there are: ode, ode-dense, bullet");
  }
}

}  // namespace
}  // namespace plumbline::simulation
