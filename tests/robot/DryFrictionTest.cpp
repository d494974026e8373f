#include "robot/DryFriction.h"

#include <gtest/gtest.h>

#include <cmath>

namespace plumbline {
namespace {

constexpr GearLoad pressed{0.8, 0.6, 0.5};  // motor, gear, link

TEST(DryFrictionTest, coulombAndStribeckAtASpeed) {
  JointPlant plant;
  plant.coulomb = 0.1;
  plant.stribeck = 0.2;
  plant.stribeckSpeed = 0.5;
  EXPECT_DOUBLE_EQ(dryFriction(plant, 0, {}).forward, 0.3);
  EXPECT_DOUBLE_EQ(dryFriction(plant, -0.5, {}).backward, 0.1 + 0.2 * std::exp(-1));
}

TEST(DryFrictionTest, loadInEachOfItsForms) {
  JointPlant plant;
  plant.loadFriction = 0.25;
  EXPECT_DOUBLE_EQ(dryFriction(plant, 1, pressed).forward, 0.25 * 0.6);
  plant.loadIs = JointPlant::Load::linkTorque;
  EXPECT_DOUBLE_EQ(dryFriction(plant, 1, pressed).forward, 0.25 * 0.5);
  plant.loadIs = JointPlant::Load::motorTorque;
  EXPECT_DOUBLE_EQ(dryFriction(plant, 1, pressed).forward, 0.25 * 0.8);
}

TEST(DryFrictionTest, loadsOfMotorAndLinkAddUpWithTheirSigns) {
  JointPlant plant;
  plant.loadFriction = 0.25;
  plant.loadIs = JointPlant::Load::motorTorque;
  plant.linkLoadFriction = 0.5;
  EXPECT_DOUBLE_EQ(dryFriction(plant, 1, pressed).forward, 0.25 * 0.8 + 0.5 * 0.5);
  EXPECT_DOUBLE_EQ(dryFriction(plant, 1, {-0.8, -0.6, 0.5}).forward, 0.5 * 0.5 - 0.25 * 0.8);
}

TEST(DryFrictionTest, whatLoadAddsAtRestFallsWithTheSpeed) {
  JointPlant plant;
  plant.loadStribeck = 0.5;
  plant.loadStribeckSpeed = 0.2;
  EXPECT_DOUBLE_EQ(dryFriction(plant, 0, pressed).forward, 0.5 * 0.6);
  EXPECT_DOUBLE_EQ(dryFriction(plant, 0.2, pressed).forward, 0.5 * 0.6 * std::exp(-1));
}

TEST(DryFrictionTest, theSquareIsOfTheSmallerTorqueWhileBothPress) {
  JointPlant plant;
  plant.quadraticLoadFriction = 2;
  const GearLoad lifted = pressed, lowered{0.3, 0.3, 0.4}, pulled{0.3, 0.3, -0.4};
  EXPECT_DOUBLE_EQ(dryFriction(plant, 0, lifted).forward, 2 * 0.5 * 0.5);
  EXPECT_DOUBLE_EQ(dryFriction(plant, 0, lowered).forward, 2 * 0.3 * 0.3);
  EXPECT_DOUBLE_EQ(dryFriction(plant, 0, pulled).forward, 0);
  plant.quadraticFlow = JointPlant::Flow::motorDrives;
  EXPECT_DOUBLE_EQ(dryFriction(plant, 0, lifted).forward, 2 * 0.5 * 0.5);
  EXPECT_DOUBLE_EQ(dryFriction(plant, 0, lowered).forward, 0);
  plant.quadraticFlow = JointPlant::Flow::loadDrives;
  EXPECT_DOUBLE_EQ(dryFriction(plant, 0, lifted).forward, 0);
  EXPECT_DOUBLE_EQ(dryFriction(plant, 0, lowered).forward, 2 * 0.3 * 0.3);
}

TEST(DryFrictionTest, oneWayMayHoldMoreThanTheOther) {
  JointPlant plant;
  plant.coulomb = 0.1;
  plant.coulombForward = 0.2;
  plant.coulombBackward = 0.05;
  const DryFriction dry = dryFriction(plant, 3, {});
  EXPECT_DOUBLE_EQ(dry.forward, 0.1 + 0.2);
  EXPECT_DOUBLE_EQ(dry.backward, 0.1 + 0.05);
}

}  // namespace
}  // namespace plumbline
