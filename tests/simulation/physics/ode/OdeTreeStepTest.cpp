#include "simulation/physics/ode/OdeTreeStep.h"

#include <gtest/gtest.h>

#include <functional>
#include <random>

#include "simspark/LeagueRobots.h"
#include "simulation/league/MakeWorld.h"
#include "simulation/physics/Physics.h"

namespace plumbline::simulation {
namespace {

/// Two worlds side by side, one on each solver. After every step the tree's world is held to the dense one's;
/// errors of rounding grow by contact, so each scene is short.
struct Pair {
  std::unique_ptr<World> tree, dense;

  explicit Pair(WorldConfig config = {}) {
    config.engine = "ode";
    tree = makeWorld(config);
    config.engine = "ode-dense";
    dense = makeWorld(config);
  }

  void both(const std::function<void(World&)>& act) {
    act(*tree);
    act(*dense);
  }

  /// Largest difference of any link's position and velocity.
  std::pair<double, double> difference(RobotHandle robot, int links) const {
    std::pair<double, double> largest{0, 0};
    for (int i = 0; i < links; ++i) {
      const BodyState a = tree->linkState(robot, i), b = dense->linkState(robot, i);
      largest.first = std::max(largest.first, (a.pose.matrix() - b.pose.matrix()).cwiseAbs().maxCoeff());
      largest.second = std::max({largest.second, (a.linearVelocity - b.linearVelocity).norm(),
                                 (a.angularVelocity - b.angularVelocity).norm()});
    }
    return largest;
  }
};

class Types : public testing::TestWithParam<int> {};

TEST_P(Types, movesAsOdeOwnSolverMoves) {
  const RobotModel model = simsparkRobot(GetParam());
  Pair worlds;
  worlds.both([&](World& w) {
    w.addRobot(model, translation(0, 0, 0.45) * rotationZ(0.3));
    w.setBall({0.3, 0.1, 0.2}, {-1, 0.2, 0.5});
  });
  std::mt19937 random(1);
  std::uniform_real_distribution<double> speed(-3, 3);
  const int links = static_cast<int>(model.links.size());
  for (int i = 0; i < 60; ++i) {
    if (i % 8 == 0)
      for (const Link& link : model.links)
        if (link.joint != noJoint) {
          const double v = speed(random);
          worlds.both([&](World& w) { w.setJointVelocity(1, link.joint, v); });
        }
    worlds.both([](World& w) { w.step(); });
    const auto [position, velocity] = worlds.difference(1, links);
    ASSERT_LT(position, 1e-6) << "cycle " << i;
    ASSERT_LT(velocity, 1e-5) << "cycle " << i;
    const auto &a = worlds.tree->readings(1).leftFoot, &b = worlds.dense->readings(1).leftFoot;
    ASSERT_EQ(a.has_value(), b.has_value()) << "cycle " << i;
    if (a) {
      ASSERT_LT((a->force - b->force).norm(), 1e-4) << "cycle " << i;
      ASSERT_LT((a->point - b->point).norm(), 1e-5) << "cycle " << i;
    }
  }
}
INSTANTIATE_TEST_SUITE_P(Robots, Types, testing::Range(0, numSimsparkTypes()));

TEST(OdeTreeStep, motorsAtTheirLimitAndStopsAsOdeHasThem) {
  const RobotModel model = simsparkRobot(0);
  Pair worlds;
  JointArray angles{};
  angles[rShoulderRoll] = -0.2;
  worlds.both([&](World& w) {
    w.addRobot(model, translation(0, 3, 2.5));
    w.setPosture(1, angles);
    // Whirled about, thrown down head first and with all joints driven into their stops.
    BodyState torso;
    torso.pose = translation(0, 3, 1.2) * rotationY(2.8);
    torso.linearVelocity = {1, 0, -5};
    torso.angularVelocity = {3, 8, -5};
    w.setState(1, torso, angles, JointArray{});
  });
  for (const Link& link : model.links)
    if (link.joint != noJoint) worlds.both([&](World& w) { w.setJointVelocity(1, link.joint, 6); });
  for (int i = 0; i < 24; ++i) {
    worlds.both([](World& w) { w.step(); });
    const auto [position, velocity] = worlds.difference(1, static_cast<int>(model.links.size()));
    ASSERT_LT(position, 1e-6) << "cycle " << i;
    ASSERT_LT(velocity, 1e-5) << "cycle " << i;
  }
  EXPECT_LT(worlds.tree->torso(1).pose.translation().z(), 0.5) << "the crash is part of this";
}

TEST(OdeTreeStep, robotsInAHeap) {
  Pair worlds;
  for (int i = 0; i < 4; ++i)
    worlds.both([&](World& w) {
      w.addRobot(simsparkRobot(i), translation(0.25 * (i % 2), 0.1 * i, 0.3 + 0.25 * i) *
                                       rotation(Vec3(1, 2, 3).normalized(), 1.0 + i));
    });
  for (int i = 0; i < 20; ++i) {
    worlds.both([](World& w) { w.step(); });
    for (RobotHandle robot = 1; robot <= 4; ++robot) {
      const auto [position, velocity] = worlds.difference(robot, 22);
      ASSERT_LT(position, 1e-6) << "robot " << robot << " cycle " << i;
      ASSERT_LT(velocity, 1e-4) << "robot " << robot << " cycle " << i;
    }
  }
}

TEST(OdeTreeStep, sleepsAndWakesInTheSameCycles) {
  Pair worlds;
  worlds.both([](World& w) {
    w.addRobot(simsparkRobot(3), translation(-0.4, 0.05, 0.45));
    w.setBall({0.5, 0, 0.3}, Vec3::Zero());
  });
  for (int i = 0; i < 150; ++i) {
    if (i == 60) worlds.both([](World& w) { w.setBall({0.4, 0, 0.042}, {-2, 0, 0}); });
    if (i == 110) worlds.both([](World& w) { w.setJointVelocity(1, headYaw, 1); });
    worlds.both([](World& w) { w.step(); });
    const auto [position, velocity] = worlds.difference(1, 22);
    ASSERT_LT(position, 1e-6) << "cycle " << i;
    ASSERT_LT(velocity, 1e-5) << "cycle " << i;
    ASSERT_LT((worlds.tree->ball().pose.matrix() - worlds.dense->ball().pose.matrix()).norm(), 1e-6) << i;
    ASSERT_EQ(worlds.tree->torso(1).linearVelocity.isZero(0), worlds.dense->torso(1).linearVelocity.isZero(0))
        << i;
  }
}

}  // namespace
}  // namespace plumbline::simulation
