#include "simulation/physics/tree/CoulombFriction.h"

#include <gtest/gtest.h>

namespace plumbline::simulation {
namespace {

/// A point of unit mass pushed onto a plane and along it: row 0 the push, row 1 friction, coupled a little.
BoundedSystem point(double push, double slide) {
  BoundedSystem system;
  system.reset(2);
  system.a(0, 0) = system.a(1, 1) = 1;
  system.a(1, 0) = 0.2;
  system.b << push, slide;
  system.lower[0] = 0;
  return system;
}

TEST(CoulombFriction, holdsWhatItCan) {
  BoundedSystem system = point(2, 0.3);
  const Eigen::VectorXd x = solveWithFriction(system, {{1, 0, 0.5}});
  EXPECT_NEAR(x[0] + 0.2 * x[1], 2, 1e-12);
  EXPECT_NEAR(0.2 * x[0] + x[1], 0.3, 1e-12) << "no sliding is left";
}

TEST(CoulombFriction, slidesAtItsLimitOfTheSameSolution) {
  BoundedSystem system = point(2, 5);
  const Eigen::VectorXd x = solveWithFriction(system, {{1, 0, 0.5}});
  EXPECT_NEAR(x[1], 0.5 * x[0], 2e-3);
  EXPECT_NEAR(x[0] + 0.2 * x[1], 2, 1e-12);
}

TEST(CoulombFriction, needsAPush) {
  BoundedSystem system = point(-1, 5);
  const Eigen::VectorXd x = solveWithFriction(system, {{1, 0, 0.5}});
  EXPECT_NEAR(x[0], 0, 1e-12);
  EXPECT_NEAR(x[1], 0, 1e-12);
}

TEST(CoulombFriction, withoutLimitsIsThePlainSystem) {
  BoundedSystem system = point(2, 5);
  const Eigen::VectorXd x = solveWithFriction(system, {});
  EXPECT_NEAR(0.2 * x[0] + x[1], 5, 1e-12);
}

}  // namespace
}  // namespace plumbline::simulation
