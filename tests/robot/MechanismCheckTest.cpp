#include "robot/MechanismCheck.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <functional>
#include <vector>

#include "robot/MechanismFile.h"

namespace plumbline {
namespace {

using Change = std::function<void(Mechanism&)>;

/// An arm of 1 kg on a base of 2 kg.
Mechanism checkedArm() {
  Mechanism m;
  m.name = "arm";
  Mechanism::Link base, link;
  base.name = "base";
  base.mass = 2;
  base.inertia = 0.01 * Mat3::Identity();
  link = base;
  link.name = "link";
  link.parent = 0;
  link.mass = 1;
  link.com = Vec3(0, 0, -0.1);
  m.links = {base, link};
  Mechanism::Joint joint;
  joint.name = "Hinge";
  joint.child = 1;
  joint.origin = Vec3(0, 0, 0.3);
  joint.lower = -2;
  joint.upper = 2;
  joint.maxTorque = 10;
  joint.maxSpeed = 6;
  joint.servo.kp = 50;
  joint.servo.kd = 1;
  m.joints = {joint};
  return m;
}

std::string errorOf(const Change& change) {
  Mechanism m = checkedArm();
  change(m);
  try {
    checkMechanism(m, "arm.json", {});
  } catch (const MechanismError& error) {
    return error.what();
  }
  return "no error";
}

std::string warningOf(const Change& change) {
  Mechanism m = checkedArm();
  change(m);
  std::string all;
  checkMechanism(m, "arm.json", [&](const std::string& line) { all += (all.empty() ? "" : "\n") + line; });
  return all;
}

TEST(MechanismCheck, aSoundRobotPassesInSilence) {
  EXPECT_EQ(warningOf([](Mechanism&) {}), "");
}

TEST(MechanismCheck, theProjectsRobotsPassInSilence) {
  std::size_t count = 0;
  for (const auto& entry : std::filesystem::directory_iterator("config/robots")) {
    if (entry.path().extension() != ".json") continue;
    readMechanism(entry.path().string(), [](const std::string& line) { ADD_FAILURE() << line; });
    ++count;
  }
  EXPECT_GE(count, 8u);
}

TEST(MechanismCheck, inertiaMustBePositiveDefinite) {
  const std::string error =
      "arm.json: link link: the inertia is not positive definite; check order and signs";
  EXPECT_EQ(errorOf([](Mechanism& m) { m.links[1].inertia(1, 1) = -0.01; }), error);
  // Singular, and turned, so that rounding makes its determinant positive.
  EXPECT_EQ(errorOf([](Mechanism& m) {
              const Mat3 turned = rotationOfRpy(Vec3(0.3, 0.5, 0.7));
              m.links[1].inertia = turned * Vec3(0, 0.01, 0.01).asDiagonal() * turned.transpose();
            }),
            error);
  EXPECT_EQ(errorOf([](Mechanism& m) { m.links[1].inertia = Mat3::Zero(); }), error);
}

TEST(MechanismCheck, principalMomentsKeepTheTriangleInequality) {
  EXPECT_EQ(
      errorOf([](Mechanism& m) { m.links[1].inertia = Vec3(0.001, 0.1, 0.001).asDiagonal(); }),
      "arm.json: link link: moments of inertia about the principal axes are 0.001, 0.001 and 0.1, which no "
      "body has: the smaller two must add up to the largest; check the order [ixx, iyy, izz, ixy, ixz, iyz] "
      "and that they are about the centre of mass");
  // A flat plate reaches the limit; its figures are rounded.
  EXPECT_EQ(
      warningOf([](Mechanism& m) { m.links[1].inertia = Vec3(0.01234, 0.02345, 0.03580).asDiagonal(); }), "");
}

TEST(MechanismCheck, numbersThatCannotBe) {
  EXPECT_EQ(errorOf([](Mechanism& m) { m.links[1].mass = 1e-300; }),
            "arm.json: link link: mass is 1e-300, which is impossible; give it kg, 1e-15 to 1e+06");
  EXPECT_EQ(errorOf([](Mechanism& m) { m.links[1].mass = 1e11; }),
            "arm.json: link link: mass is 1e+11, which is impossible; give it kg, 1e-15 to 1e+06");
  EXPECT_EQ(
      errorOf([](Mechanism& m) { m.links[1].inertia = 1e9 * Mat3::Identity(); }),
      "arm.json: link link: the largest moment of inertia is 1e+09, which is impossible; give it kg m^2, "
      "1e-15 to "
      "1e+08");
  EXPECT_EQ(errorOf([](Mechanism& m) { m.gravity = Vec3(0, 0, -1e11); }),
            "arm.json: gravity is 1e+11, which is impossible; give it m/s^2, 0 to 100000");
  EXPECT_EQ(errorOf([](Mechanism& m) { m.joints[0].maxTorque = 1e-300; }),
            "arm.json: joint Hinge: max_torque is 1e-300, which is impossible; give it N m, 1e-09 to 1e+09");
  EXPECT_EQ(errorOf([](Mechanism& m) { m.joints[0].friction = 1e10; }),
            "arm.json: joint Hinge: friction is 1e+10, which is impossible; give it N m, 0 to 1e+09");
  EXPECT_EQ(errorOf([](Mechanism& m) { m.joints[0].damping = -1; }),
            "arm.json: joint Hinge: damping is -1, which is impossible; give it N m s/rad, 0 to 1e+09");
  EXPECT_EQ(errorOf([](Mechanism& m) { m.joints[0].servo.kp = 0; }), "no error") << "torques alone";
  EXPECT_EQ(errorOf([](Mechanism& m) { m.joints[0].upper = 5000; }),
            "arm.json: joint Hinge: upper is 5000, which is impossible; give it in rad, -1000 to 1000 for a "
            "joint without "
            "stops");
  EXPECT_EQ(errorOf([](Mechanism& m) { m.links[1].com.x() = 2000; }),
            "arm.json: link link: com is 2000 m away, which is impossible; give it in m");
}

TEST(MechanismCheck, otherUnitsAreDoubted) {
  EXPECT_EQ(warningOf([](Mechanism& m) { m.joints[0].lower = -90, m.joints[0].upper = 90; }),
            "arm.json: joint Hinge: lower is -90, 14.3 turns; is it in rad? A joint without stops has 1000\n"
            "arm.json: joint Hinge: upper is 90, 14.3 turns; is it in rad? A joint without stops has 1000");
  EXPECT_EQ(warningOf([](Mechanism& m) { m.links[1].com *= 1000; }),
            "arm.json: link link: com is 100 m away, farther than the robot is long; is it in m?");
  EXPECT_EQ(warningOf([](Mechanism& m) { m.joints[0].origin *= 1000; }),
            "arm.json: joint Hinge: the distance of its origin from the parent's is 300, far from the "
            "largest known of "
            "robots; is it in m?");
  EXPECT_EQ(warningOf([](Mechanism& m) { m.joints[0].maxSpeed = 360; }),
            "arm.json: joint Hinge: max_speed is 360, far from the largest known of robots; is it in rad/s?");
  EXPECT_EQ(warningOf([](Mechanism& m) { m.gravity.z() = -9810; }),
            "arm.json: gravity is 9810, far from the largest known of robots; is it in m/s^2?");
  // A dog of 15 tonnes.
  EXPECT_EQ(warningOf([](Mechanism& m) {
              for (auto& link : m.links) link.mass *= 5000, link.inertia *= 5000;
            }),
            "arm.json: link base: mass is 10000, far from the largest known of robots; is it in kg?\n"
            "arm.json: link link: mass is 5000, far from the largest known of robots; is it in kg?\n"
            "arm.json: the mass of all links is 15000, far from the largest known of robots; is it in kg?");
  // kg mm^2 for kg m^2.
  EXPECT_EQ(warningOf([](Mechanism& m) { m.links[1].inertia *= 1e6; }),
            "arm.json: link link: mass and inertia are those of a body of radius 100 m; are they in kg and "
            "kg m^2?");
}

TEST(MechanismCheck, jointsWithoutStopsAndSlidesAreSound) {
  EXPECT_EQ(warningOf([](Mechanism& m) { m.joints[0].lower = -1000, m.joints[0].upper = 1000; }), "");
  EXPECT_EQ(warningOf([](Mechanism& m) {
              m.joints[0].type = Mechanism::Joint::Type::prismatic;
              m.joints[0].lower = -0.2, m.joints[0].upper = 0.8;
              m.joints[0].maxTorque = 20000, m.joints[0].servo.kp = 1e6;
            }),
            "");
}

}  // namespace
}  // namespace plumbline
