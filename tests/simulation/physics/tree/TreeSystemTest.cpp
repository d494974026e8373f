#include "simulation/physics/tree/TreeSystem.h"

#include <gtest/gtest.h>

#include <Eigen/LU>
#include <random>
#include <stdexcept>

namespace plumbline::simulation {
namespace {

constexpr double h = 0.02;

/// A tree of five bodies with random masses, places, gaps and wishes.
class RandomTree : public testing::Test {
protected:
  RandomTree() : tree(parents) {
    for (int i = 0; i < count; ++i) {
      TreeSystem::Body& body = tree.body(i);
      body.mass = 0.05 + uniform();
      const Vec3 d = Vec3(1, 1.5, 0.8) * (1e-3 * (1 + uniform()));
      const Mat3 r = Eigen::AngleAxisd(uniform(), vector().normalized()).toRotationMatrix();
      body.inertia = r * d.asDiagonal() * r.transpose();
      body.position = 0.3 * vector();
      body.linearVelocity = vector();
      body.angularVelocity = 3 * vector();
      body.force = vector();
      body.torque = 0.1 * vector();
      if (i == 0) continue;
      TreeSystem::Joint& joint = tree.joint(i);
      joint.childAnchor = 0.3 * vector();
      joint.parentAnchor = joint.childAnchor + 1e-3 * vector();
      joint.axis = vector().normalized();
      joint.linear = 0.01 * vector();
      joint.angular = vector();
      joint.compliance = 5e-4;
      joint.axisCompliance = 5e-7;
      joint.axisFree = i == 3;
    }
  }

  double uniform() { return std::uniform_real_distribution<double>(0, 1)(random); }
  Vec3 vector() { return Vec3(2 * uniform() - 1, 2 * uniform() - 1, 2 * uniform() - 1); }

  /// The same equations as one dense system in velocities of centres of mass and impulses at the anchors;
  /// impulses from outside are added at O.
  Eigen::VectorXd dense(const std::vector<Vec6>& pushes) {
    const int n = 6 * count, m = 6 * (count - 1);
    Eigen::MatrixXd k = Eigen::MatrixXd::Zero(n + m, n + m);
    Eigen::VectorXd side = Eigen::VectorXd::Zero(n + m);
    for (int i = 0; i < count; ++i) {
      const TreeSystem::Body& b = tree.body(i);
      k.block<3, 3>(6 * i, 6 * i) = b.mass * Mat3::Identity();
      k.block<3, 3>(6 * i + 3, 6 * i + 3) = b.inertia;
      const Vec3 f = pushes[static_cast<std::size_t>(i)].head<3>(),
                 t = pushes[static_cast<std::size_t>(i)].tail<3>();
      side.segment<3>(6 * i) = b.mass * b.linearVelocity + h * b.force + f;
      side.segment<3>(6 * i + 3) = b.inertia * b.angularVelocity + h * b.torque + t - b.position.cross(f);
      if (i == 0) continue;
      const TreeSystem::Joint& joint = tree.joint(i);
      const int p = parents[static_cast<std::size_t>(i)], row = n + 6 * (i - 1);
      Eigen::MatrixXd j = Eigen::MatrixXd::Zero(6, n);
      j.block<3, 3>(0, 6 * i).setIdentity();
      j.block<3, 3>(0, 6 * i + 3) = -cross(joint.childAnchor - b.position);
      j.block<3, 3>(0, 6 * p) = -Mat3::Identity();
      j.block<3, 3>(0, 6 * p + 3) = cross(joint.parentAnchor - tree.body(p).position);
      j.block<3, 3>(3, 6 * i + 3).setIdentity();
      j.block<3, 3>(3, 6 * p + 3) = -Mat3::Identity();
      Eigen::MatrixXd c = joint.compliance * Eigen::MatrixXd::Identity(6, 6);
      const double axisCompliance = joint.axisFree ? 1e9 : joint.axisCompliance;
      c.block<3, 3>(3, 3) += (axisCompliance - joint.compliance) * joint.axis * joint.axis.transpose();
      k.block(row, 0, 6, n) = j;
      k.block(0, row, n, 6) = -j.transpose();
      k.block(row, row, 6, 6) = c;
      side.segment<3>(row) = joint.linear;
      side.segment<3>(row + 3) = joint.angular;
    }
    return k.fullPivLu().solve(side);
  }

  double error(const std::vector<Vec6>& pushes) {
    const Eigen::VectorXd x = dense(pushes);
    double largest = 0;
    for (int i = 0; i < count; ++i) {
      const Vec6& v = tree.velocity(i);
      largest = std::max(largest, (velocityAt(v, tree.body(i).position) - x.segment<3>(6 * i)).norm());
      largest = std::max(largest, (v.tail<3>() - x.segment<3>(6 * i + 3)).norm());
    }
    return largest;
  }

  static constexpr int count = 5;
  std::vector<int> parents = {-1, 0, 1, 0, 1};
  std::vector<Vec6> none = std::vector<Vec6>(count, Vec6::Zero());
  std::mt19937 random{3};
  TreeSystem tree;
};

TEST_F(RandomTree, solvesWhatADenseSystemSolves) {
  tree.factor();
  tree.solve(h);
  EXPECT_LT(error(none), 1e-6) << "a free axis is a very soft one in the dense system";
  const Eigen::VectorXd x = dense(none);
  const auto angularImpulse = x.segment<3>(6 * count + 6 * 1 + 3);
  EXPECT_NEAR(tree.motorImpulse(2), tree.joint(2).axis.dot(Vec3(angularImpulse)), 1e-7);
}

TEST_F(RandomTree, takesPushesFromOutside) {
  tree.factor();
  tree.solve(h);
  std::vector<Vec6> pushes = none;
  for (const int body : {0, 2, 4})
    for (int i = 0; i < 6; ++i) pushes[static_cast<std::size_t>(body)][i] = uniform() - 0.5;
  for (int i = 0; i < count; ++i) tree.push(i, pushes[static_cast<std::size_t>(i)]);
  tree.resolve();
  EXPECT_LT(error(pushes), 1e-6);
  tree.solve(h);
  EXPECT_LT(error(none), 1e-6) << "a new solution knows no pushes";
}

TEST_F(RandomTree, responseIsTheChangeOfVelocityByAPush) {
  tree.factor();
  for (int b = 0; b < count; ++b)
    for (int direction = 0; direction < 6; ++direction) {
      tree.solve(h);
      std::vector<Vec6> before;
      for (int a = 0; a < count; ++a) before.push_back(tree.velocity(a));
      tree.push(b, Vec6::Unit(direction));
      tree.resolve();
      for (int a = 0; a < count; ++a) {
        const Vec6 change = tree.velocity(a) - before[static_cast<std::size_t>(a)];
        EXPECT_LT((change - tree.response(a, b).col(direction)).norm(), 1e-9 * change.norm() + 1e-9);
      }
    }
}

/// To the bit: a game must not depend on what was worked out before.
TEST_F(RandomTree, freeingAxesGivesWhatFactoringAnewGives) {
  for (const std::vector<int>& freed : {std::vector<int>{2}, {4}, {1, 4}, {}}) {
    TreeSystem anew = tree;
    tree.factor();
    tree.response(4, 2);  // known before
    for (const int child : freed) {
      tree.freeAxis(child);
      anew.joint(child).axisFree = true;
    }
    tree.refactor();
    anew.factor();
    tree.solve(h);
    anew.solve(h);
    for (int a = 0; a < count; ++a) {
      EXPECT_TRUE(tree.velocity(a) == anew.velocity(a)) << a;
      for (int b = 0; b < count; ++b)
        EXPECT_TRUE(tree.response(a, b) == anew.response(a, b)) << a << ' ' << b;
    }
  }
}

TEST_F(RandomTree, aFreeAxisHasNoImpulse) {
  tree.factor();
  tree.solve(h);
  EXPECT_NEAR(tree.motorImpulse(3), 0, 1e-12);
}

TEST(TreeSystem, refusesChildrenBeforeParents) {
  EXPECT_THROW(TreeSystem({-1, 2, 0}), std::invalid_argument);
  EXPECT_THROW(TreeSystem({-1, -1}), std::invalid_argument);
}

TEST(Spatial, inverse) {
  const Mat6 m = spatialInertia(0.035, Mat3::Identity() * 1.4e-6, Vec3(0.1, -0.2, 0.3));
  EXPECT_LT((m * inverseSpd(m) - Mat6::Identity()).norm(), 1e-9);
}

}  // namespace
}  // namespace plumbline::simulation
