#include "simulation/physics/tree/BoundedSystem.h"

#include <gtest/gtest.h>

#include <limits>
#include <random>

namespace plumbline::simulation {
namespace {

TEST(BoundedSystem, withoutBoundsItIsALinearSystem) {
  BoundedSystem system;
  system.reset(2);
  system.a << 4, 0, 1, 3;
  system.b << 1, 2;
  const Eigen::VectorXd x = system.solve();
  EXPECT_NEAR(x[0], 1.0 / 11, 1e-14);
  EXPECT_NEAR(x[1], 7.0 / 11, 1e-14);
}

TEST(BoundedSystem, aPushCannotPull) {
  BoundedSystem system;
  system.reset(1);
  system.a << 2;
  system.b << -3;
  system.lower[0] = 0;
  EXPECT_EQ(system.solve()[0], 0);
  system.upper[0] = 1;
  system.b << 3;
  EXPECT_EQ(system.solve()[0], 1);
  system.b << 1;
  EXPECT_DOUBLE_EQ(system.solve()[0], 0.5);
}

TEST(BoundedSystem, nothingIsSolvedToo) {
  BoundedSystem system;
  system.reset(0);
  EXPECT_EQ(system.solve().size(), 0);
}

/// Random systems with rows of all kinds: the solution must satisfy the conditions that define it.
TEST(BoundedSystem, satisfiesItsConditions) {
  std::mt19937 random(7);
  std::normal_distribution<double> normal;
  BoundedSystem system;
  int atBounds = 0;
  for (int trial = 0; trial < 300; ++trial) {
    const Eigen::Index n = 1 + trial % 40;
    Eigen::MatrixXd m(n, n);
    for (Eigen::Index i = 0; i < m.size(); ++i) m.data()[i] = normal(random);
    const Eigen::MatrixXd a = m * m.transpose() + 1e-3 * Eigen::MatrixXd::Identity(n, n);
    system.reset(n);
    system.a = a.triangularView<Eigen::Lower>();
    for (Eigen::Index i = 0; i < n; ++i) {
      system.b[i] = 3 * normal(random);
      if (i % 3 == 0) system.lower[i] = 0;
      if (i % 6 == 1) {
        system.lower[i] = -0.3;
        system.upper[i] = 0.2;
      }
    }
    const Eigen::VectorXd x = system.solve();
    const Eigen::VectorXd w = a * x - system.b;
    for (Eigen::Index i = 0; i < n; ++i) {
      ASSERT_GE(x[i], system.lower[i] - 1e-11) << trial;
      ASSERT_LE(x[i], system.upper[i] + 1e-11) << trial;
      const double tolerance = 1e-8 * (1 + x.norm() * a.norm());
      if (x[i] > system.lower[i] + 1e-11) {
        ASSERT_LT(w[i], tolerance) << trial;
      }
      if (x[i] < system.upper[i] - 1e-11) {
        ASSERT_GT(w[i], -tolerance) << trial;
      }
      atBounds += x[i] <= system.lower[i] || x[i] >= system.upper[i] ? 1 : 0;
    }
  }
  EXPECT_GT(atBounds, 500);
}

}  // namespace
}  // namespace plumbline::simulation
