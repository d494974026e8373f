#include "simulation/physics/Drag.h"

#include <gtest/gtest.h>

namespace plumbline::simulation {
namespace {

constexpr double step = 0.02;

BodySpec body(double inertia, double drag) {
  BodySpec spec;
  spec.inertia = Mat3::Identity() * inertia;
  spec.angularDrag = drag;
  return spec;
}

/// The spin about x after a step, of a body that nothing holds.
double spinAfter(const BodySpec& spec, double spin) {
  return spin + step * dragTorque(spec, Mat3::Identity(), {spin, 0, 0}, step).x() / spec.inertia(0, 0);
}

TEST(Drag, isOfTheBeginningOfTheStepAsOnTheLeaguesServer) {
  EXPECT_EQ(dragTorque(body(1e-5, 0.01), Mat3::Identity(), {3, -4, 12}, step), Vec3(-0.03, 0.04, -0.12));
  EXPECT_NEAR(spinAfter(body(1e-5, 0.01), 10), -190, 1e-9)
      << "a light link is turned round, its motor holds it";
}

TEST(Drag, brakesALightLinkThatSpinsFast) {
  EXPECT_NEAR(spinAfter(body(1e-5, 0.01), 90), 90 / 21.0, 1e-9);
  EXPECT_NEAR(spinAfter(body(1e-5, 0.01), -1e6), -1e6 / 21, 1e-6);
}

TEST(Drag, isTheServersForABallHoweverFastItSpins) {
  const BodySpec ball = body(1.8e-5, 5e-5);
  EXPECT_EQ(dragTorque(ball, Mat3::Identity(), {0, 150, 0}, step), Vec3(0, -5e-5 * 150, 0));
}

TEST(Drag, isAboutTheBodysOwnAxes) {
  BodySpec spec = body(1e-5, 0.01);
  spec.inertia(2, 2) = 1e-2;
  const Mat3 turned = rotation(Vec3(Vec3::UnitY()), 1.5707963267948966).linear();  // its z is the world's x
  const Vec3 torque = dragTorque(spec, turned, {100, 0, 0}, step);
  EXPECT_NEAR(torque.x(), -0.01 * 100 / 1.02, 1e-9);
  EXPECT_NEAR(torque.tail<2>().norm(), 0, 1e-12);
}

}  // namespace
}  // namespace plumbline::simulation
