// How geoms of an MJCF file turn: their inertias against an integral over discs, which knows none of the
// closed forms.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>

#include "robot/MechanismFileFixture.h"

namespace plumbline {
namespace {

using MjcfSolids = MechanismFileFixture;

/// Mass [kg] and moments of inertia [kg m^2] across the axis and about it.
struct Moments {
  double mass = 0, across = 0, about = 0;
};

/// A solid of revolution of 1000 kg/m^3 about z, symmetric to the origin: radius [m] at a height, half of its
/// length [m]. Midpoint rule; the error is below 1e-6 of each value.
Moments revolved(const std::function<double(double)>& radius, double half) {
  constexpr int discs = 20000;
  const double thickness = 2 * half / discs;
  Moments sum;
  for (int i = 0; i < discs; ++i) {
    const double z = -half + (i + 0.5) * thickness, r = radius(z);
    const double mass = 1000 * M_PI * r * r * thickness;
    sum.mass += mass;
    sum.about += mass * r * r / 2;
    sum.across += mass * (r * r / 4 + z * z);
  }
  return sum;
}

/// A round part of a circle of this radius [m] at a distance [m] from its centre.
double circle(double radius, double distance) {
  return std::sqrt(std::max(0.0, radius * radius - distance * distance));
}

std::string body(const std::string& geom) {
  return R"(<mujoco model="solid"><worldbody><body name="solid"><freejoint/>)" + geom +
         R"(</body></worldbody></mujoco>)";
}

Mechanism::Link linkOf(const std::string& path) {
  return readMechanism(path, [](const std::string&) {}).links[0];
}

void expectMoments(const Mechanism::Link& link, const Moments& wanted) {
  EXPECT_NEAR(link.mass, wanted.mass, 1e-5 * wanted.mass);
  EXPECT_NEAR(link.inertia(0, 0), wanted.across, 1e-5 * wanted.across);
  EXPECT_NEAR(link.inertia(1, 1), wanted.across, 1e-5 * wanted.across);
  EXPECT_NEAR(link.inertia(2, 2), wanted.about, 1e-5 * wanted.about);
}

TEST_F(MjcfSolids, aCylinderTurnsAsItsDiscs) {
  const auto link = linkOf(write("solid.xml", body(R"(<geom type="cylinder" size="0.1 0.2"/>)")));
  expectMoments(link, revolved([](double) { return 0.1; }, 0.2));
}

TEST_F(MjcfSolids, aCapsuleTurnsAsItsDiscs) {
  const auto link = linkOf(write("solid.xml", body(R"(<geom type="capsule" size="0.1 0.2"/>)")));
  expectMoments(link, revolved([](double z) { return circle(0.1, std::max(0.0, std::abs(z) - 0.2)); }, 0.3));
}

TEST_F(MjcfSolids, aBallTurnsAsItsDiscs) {
  const auto link = linkOf(write("solid.xml", body(R"(<geom type="sphere" size="0.15"/>)")));
  expectMoments(link, revolved([](double z) { return circle(0.15, z); }, 0.15));
}

TEST_F(MjcfSolids, anEllipsoidTurnsAsItsDiscs) {
  const auto link = linkOf(write("solid.xml", body(R"(<geom type="ellipsoid" size="0.1 0.1 0.3"/>)")));
  expectMoments(link, revolved([](double z) { return circle(0.1, z / 3); }, 0.3));
}

/// Between two points along x: its axis is x, its centre half-way.
TEST_F(MjcfSolids, fromPointToPointIsTheSameSolidTurned) {
  const Moments wanted =
      revolved([](double z) { return circle(0.1, std::max(0.0, std::abs(z) - 0.2)); }, 0.3);
  const auto link =
      linkOf(write("solid.xml", body(R"(<geom type="capsule" size="0.1" fromto="0.1 0 0 0.5 0 0"/>)")));
  EXPECT_NEAR((link.com - Vec3(0.3, 0, 0)).norm(), 0, 1e-12);
  EXPECT_NEAR(link.inertia(0, 0), wanted.about, 1e-5 * wanted.about);
  EXPECT_NEAR(link.inertia(1, 1), wanted.across, 1e-5 * wanted.across);
  EXPECT_NEAR(link.inertia(2, 2), wanted.across, 1e-5 * wanted.across);
}

/// By its axis, of any length; along z and against it nothing is turned away.
TEST_F(MjcfSolids, anAxisTurnsTheSolid) {
  const Moments wanted = revolved([](double) { return 0.1; }, 0.2);
  const auto withAxis = [this](const std::string& axis) {
    return linkOf(
        write("solid.xml", body("<geom type=\"cylinder\" size=\"0.1 0.2\" zaxis=\"" + axis + "\"/>")));
  };
  EXPECT_NEAR(withAxis("0 3 0").inertia(1, 1), wanted.about, 1e-5 * wanted.about);
  EXPECT_NEAR(withAxis("0 3 0").inertia(2, 2), wanted.across, 1e-5 * wanted.across);
  expectMoments(withAxis("0 0 2"), wanted);
  expectMoments(withAxis("0 0 -2"), wanted);
}

}  // namespace
}  // namespace plumbline
