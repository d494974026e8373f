#include "gap/replay/TreeDynamics.h"

#include <gtest/gtest.h>

#include "../TwoJointArm.h"
#include "robot/MechanismFile.h"

namespace plumbline::gap {
namespace {

TEST(TreeDynamicsTest, gravityTorqueOfAHorizontalArm) {
  const Mechanism arm = twoJointArm();
  TreeDynamics tree(arm, {0, 1}, false);
  const double q[2] = {-M_PI / 2, 0}, v[2] = {0, 0};
  tree.update(Mat3::Identity(), q, v);
  // Both masses on one side at 0.2 m and 0.4 m: turning by -90 degrees about y brings -z to +x.
  EXPECT_NEAR(std::abs(tree.bias()[0]), 9.81 * (0.3 * 0.2 + 0.2 * 0.4), 1e-12);
  EXPECT_NEAR(std::abs(tree.bias()[1]), 9.81 * 0.2 * 0.2, 1e-12);
}

TEST(TreeDynamicsTest, massMatrixOfTheDoublePendulum) {
  const Mechanism arm = twoJointArm();
  TreeDynamics tree(arm, {0, 1}, false);
  const double q[2] = {0.3, 0.7}, v[2] = {0, 0};
  tree.update(Mat3::Identity(), q, v);
  const double l = 0.2, m1 = 0.3, m2 = 0.2, I = 1e-5, c = std::cos(0.7);
  EXPECT_NEAR(tree.mass()(1, 1), m2 * l * l + I, 1e-12);
  EXPECT_NEAR(tree.mass()(0, 1), m2 * l * l * (1 + c) + I, 1e-12);
  EXPECT_NEAR(tree.mass()(0, 0), m1 * l * l + m2 * l * l * (2 + 2 * c) + 2 * I, 1e-12);
}

TEST(TreeDynamicsTest, coriolisForceOfTheDoublePendulum) {
  Mechanism arm = twoJointArm();
  arm.gravity.setZero();
  TreeDynamics tree(arm, {0, 1}, false);
  const double q[2] = {0.3, 0.7}, v[2] = {1.1, -0.6};
  tree.update(Mat3::Identity(), q, v);
  const double h = 0.2 * 0.2 * 0.2 * std::sin(0.7);
  EXPECT_NEAR(tree.bias()[0], -h * (2 * v[0] * v[1] + v[1] * v[1]), 1e-12);
  EXPECT_NEAR(tree.bias()[1], h * v[0] * v[0], 1e-12);
}

TEST(TreeDynamicsTest, aFreeRobotInFreeFallNeedsNoForce) {
  const Mechanism nao = findMechanism("nao_v5");
  std::vector<int> joints(nao.joints.size());
  for (std::size_t i = 0; i < joints.size(); ++i) joints[i] = static_cast<int>(i);
  TreeDynamics tree(nao, joints, true);
  std::vector<double> q(joints.size(), 0.2), v(static_cast<std::size_t>(tree.size()), 0.0);
  const Mat3 R = Eigen::AngleAxisd(0.4, Vec3(1, 2, 3).normalized()).toRotationMatrix();
  tree.update(R, q.data(), v.data());
  Eigen::VectorXd fall = Eigen::VectorXd::Zero(tree.size());
  fall.head<3>() = nao.gravity;
  EXPECT_LT((tree.mass() * fall + tree.bias()).norm(), 1e-9);
  EXPECT_NEAR(tree.mass()(0, 0), nao.totalMass(), 1e-9);
  EXPECT_LT((tree.mass() - tree.mass().transpose()).norm(), 1e-12);
  EXPECT_LT(tree.specificForceAt(0, Vec3(0.1, 0, 0), fall.data()).norm(), 1e-9);
}

TEST(TreeDynamicsTest, jacobianIsTheDerivativeOfAPoint) {
  const Mechanism nao = findMechanism("nao_v5");
  std::vector<int> joints(nao.joints.size());
  for (std::size_t i = 0; i < joints.size(); ++i) joints[i] = static_cast<int>(i);
  TreeDynamics tree(nao, joints, false);
  std::vector<double> q(joints.size()), zero(joints.size(), 0.0);
  for (std::size_t i = 0; i < q.size(); ++i) q[i] = 0.05 * static_cast<double>(i % 7) - 0.1;
  const int foot = nao.feet[0].link;
  const Vec3 local(0.05, 0.01, -0.04);
  const auto point = [&] {
    tree.update(Mat3::Identity(), q.data(), zero.data());
    return Vec3(tree.origin(foot) + tree.rotation(foot) * local);
  };
  const Vec3 at = point();
  Eigen::MatrixXd J(3, tree.size());
  tree.jacobian(foot, at, J);
  for (std::size_t j = 0; j < q.size(); ++j) {
    const double keep = q[j], step = 1e-6;
    q[j] = keep + step;
    const Vec3 up = point();
    q[j] = keep - step;
    const Vec3 down = point();
    q[j] = keep;
    EXPECT_LT(((up - down) / (2 * step) - J.col(static_cast<Eigen::Index>(j))).norm(), 1e-8)
        << nao.joints[j].name;
  }
}

TEST(TreeDynamicsTest, turnsAndSlidesAlongAnyAxis) {
  const Vec3 slanted = Vec3(1, -2, 3).normalized();
  const double q[2] = {0.8, -1.9}, v[2] = {0, 0};
  for (const Vec3& axis :
       {Vec3(1, 0, 0), Vec3(0, 1, 0), Vec3(0, 0, 1), Vec3(-1, 0, 0), Vec3(0, -1, 0), Vec3(0, 0, -1), slanted})
    for (const auto type : {Mechanism::Joint::Type::revolute, Mechanism::Joint::Type::prismatic}) {
      Mechanism arm = twoJointArm();
      for (std::size_t j = 0; j < 2; ++j) {
        arm.joints[j].axis = axis;
        arm.joints[j].type = type;
        arm.joints[j].rpy = Vec3(0.2, 0.5, -0.4) * static_cast<double>(j);
      }
      TreeDynamics tree(arm, {0, 1}, false);
      tree.update(Mat3::Identity(), q, v);
      const Pose3 T = arm.joints[0].T_parent_child(q[0]) * arm.joints[1].T_parent_child(q[1]);
      EXPECT_LT((tree.rotation(2) - T.linear()).norm(), 1e-14) << axis.transpose();
      EXPECT_LT((tree.origin(2) - T.translation()).norm(), 1e-14) << axis.transpose();
    }
}

TEST(TreeDynamicsTest, aJointNeedsWhatCarriesIt) {
  const Mechanism arm = twoJointArm();
  try {
    TreeDynamics(arm, {1}, false);
    FAIL();
  } catch (const std::invalid_argument& error) {
    EXPECT_STREQ(error.what(), "joint elbow without the joints that carry it");
  }
}

}  // namespace
}  // namespace plumbline::gap
