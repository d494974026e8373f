#include "robot/MechanismWriter.h"

#include <gtest/gtest.h>

#include "robot/MechanismFile.h"
#include "support/ScratchFolder.h"

namespace plumbline {
namespace {

Mechanism readBack(const Mechanism& robot) {
  const test::ScratchFolder scratch;
  scratch.write("robot.json", mechanismText(robot));
  return readMechanism(scratch / "robot.json", [](const std::string&) {});
}

class WrittenMechanism : public testing::TestWithParam<const char*> {};

TEST_P(WrittenMechanism, isReadBackAsItWas) {
  const Mechanism robot = findMechanism(GetParam()), back = readBack(robot);
  EXPECT_EQ(back.name, robot.name);
  EXPECT_EQ(back.gravity, robot.gravity);
  EXPECT_EQ(back.controlHz, robot.controlHz);
  ASSERT_EQ(back.links.size(), robot.links.size());
  for (std::size_t i = 0; i < robot.links.size(); ++i) {
    EXPECT_EQ(back.links[i].name, robot.links[i].name);
    EXPECT_EQ(back.links[i].mass, robot.links[i].mass);
    EXPECT_EQ(back.links[i].com, robot.links[i].com);
    EXPECT_EQ(back.links[i].inertia, robot.links[i].inertia);
    EXPECT_EQ(back.links[i].shape.has_value(), robot.links[i].shape.has_value());
    EXPECT_EQ(back.links[i].collides, robot.links[i].collides);
  }
  ASSERT_EQ(back.joints.size(), robot.joints.size());
  for (std::size_t i = 0; i < robot.joints.size(); ++i) {
    const Mechanism::Joint &a = back.joints[i], &b = robot.joints[i];
    EXPECT_EQ(a.name, b.name);
    EXPECT_EQ(a.type, b.type);
    EXPECT_EQ(a.parent, b.parent);
    EXPECT_EQ(a.child, b.child);
    EXPECT_EQ(a.origin, b.origin);
    EXPECT_EQ(a.rpy, b.rpy);
    EXPECT_EQ(a.axis, b.axis);
    EXPECT_EQ(a.lower, b.lower);
    EXPECT_EQ(a.upper, b.upper);
    EXPECT_EQ(a.maxTorque, b.maxTorque);
    EXPECT_EQ(a.maxSpeed, b.maxSpeed);
    EXPECT_EQ(a.encoder, b.encoder);
    EXPECT_EQ(a.servo, b.servo);
    EXPECT_EQ(a.friction, b.friction);
    EXPECT_EQ(a.damping, b.damping);
    EXPECT_EQ(a.driver, b.driver);
    EXPECT_EQ(a.driverRatio, b.driverRatio);
    EXPECT_EQ(a.driverOffset, b.driverOffset);
  }
  ASSERT_EQ(back.feet.size(), robot.feet.size());
  for (std::size_t i = 0; i < robot.feet.size(); ++i) {
    EXPECT_EQ(back.feet[i].name, robot.feet[i].name);
    EXPECT_EQ(back.feet[i].link, robot.feet[i].link);
    EXPECT_EQ(back.feet[i].soleCentre, robot.feet[i].soleCentre);
    EXPECT_EQ(back.feet[i].soleSize, robot.feet[i].soleSize);
    EXPECT_EQ(back.feet[i].sensors.size(), robot.feet[i].sensors.size());
  }
  EXPECT_EQ(back.hasImu, robot.hasImu);
  EXPECT_EQ(back.imu.link, robot.imu.link);
  EXPECT_EQ(back.imu.gyro, robot.imu.gyro);
  ASSERT_EQ(back.groups.size(), robot.groups.size());
  for (std::size_t i = 0; i < robot.groups.size(); ++i)
    EXPECT_EQ(back.groups[i].joints, robot.groups[i].joints);
}

INSTANTIATE_TEST_SUITE_P(Robots, WrittenMechanism,
                         testing::Values("nao_v5", "xl330_pendulum", "so101", "simspark_type4"));

TEST(MechanismWriter, shapesDriversSlidersFrictionAndEncodersAreKept) {
  Mechanism robot = findMechanism("nao_v5");
  Shape capsule;
  capsule.kind = Shape::Kind::capsule;
  capsule.size = Vec3(0.02, 0, 0.1);
  capsule.T_link_shape.translation() = Vec3(0, 0, 0.05);
  robot.links[1].shape = capsule;
  robot.links[1].collides = true;
  robot.joints[0].type = Mechanism::Joint::Type::prismatic;
  robot.joints[1].encoder = Mechanism::Joint::Encoder::link;
  robot.joints[3].driver = 2;
  robot.joints[3].driverRatio = -0.5;
  robot.joints[3].driverOffset = 0.1;
  robot.joints[4].friction = 0.02;
  robot.joints[4].damping = 0.3;
  robot.joints[5].servo.kp = 0;
  const Mechanism back = readBack(robot);
  ASSERT_TRUE(back.links[1].shape.has_value());
  EXPECT_EQ(back.links[1].shape->kind, Shape::Kind::capsule);
  EXPECT_EQ(back.links[1].shape->size, capsule.size);
  EXPECT_EQ(back.links[1].shape->T_link_shape.translation(), Vec3(0, 0, 0.05));
  EXPECT_TRUE(back.links[1].collides);
  EXPECT_EQ(back.joints[0].type, Mechanism::Joint::Type::prismatic);
  EXPECT_EQ(back.joints[1].encoder, Mechanism::Joint::Encoder::link);
  EXPECT_EQ(back.joints[3].driver, 2);
  EXPECT_EQ(back.joints[3].driverRatio, -0.5);
  EXPECT_EQ(back.joints[3].driverOffset, 0.1);
  EXPECT_EQ(back.joints[4].friction, 0.02);
  EXPECT_EQ(back.joints[4].damping, 0.3);
  EXPECT_EQ(back.joints[5].servo.kp, 0);
}

TEST(MechanismWriter, aBaseWithoutMassGetsALittle) {
  Mechanism robot = findMechanism("xl330_pendulum");
  robot.links[0].mass = 0;
  EXPECT_NEAR(readBack(robot).links[0].mass, 0, 1e-5);
}

}  // namespace
}  // namespace plumbline
