#include "gap/diagnosis/DeviatingJoints.h"

#include <gtest/gtest.h>

#include "../TwoJointArm.h"

namespace plumbline::gap {
namespace {

/// So many pendulums on one base, each a chain of its own.
Mechanism pendulums(int count) {
  const Mechanism arm = twoJointArm();
  Mechanism robot = arm;
  robot.name = "pendulums";
  robot.links.resize(1);
  robot.joints.clear();
  for (int i = 0; i < count; ++i) {
    robot.links.push_back(arm.links[1]);
    robot.links.back().name = "link" + std::to_string(i);
    robot.joints.push_back(arm.joints[0]);
    robot.joints.back().name = "joint" + std::to_string(i);
    robot.joints.back().child = i + 1;
    robot.joints.back().origin = Vec3(0, i, 0.5);
  }
  return robot;
}

/// A recording in which the first joints have friction.
Evidence withFriction(const Mechanism& robot, int joints) {
  Explanation causes;
  for (int i = 0; i < joints; ++i)
    causes.push_back(causeOf(robot, "coulomb_friction", ("joint" + std::to_string(i)).c_str(), 0.3));
  const Trial trial = armTrial(robot, 3);
  return Evidence({recorded(plantOf(trial, causes), trial, 5e-4, 3)});
}

bool mostDeviate(int joints, int withCause) {
  const Mechanism robot = pendulums(joints);
  const Evidence evidence = withFriction(robot, withCause);
  return mostDeviates(Evaluator(robot, evidence));
}

TEST(DeviatingJoints, mostDeviateWhereThreeOfFourChainsDo) {
  EXPECT_FALSE(mostDeviate(4, 0));
  EXPECT_FALSE(mostDeviate(4, 2));
  EXPECT_FALSE(mostDeviate(5, 3));
  EXPECT_TRUE(mostDeviate(4, 3));
  EXPECT_TRUE(mostDeviate(5, 5));
}

TEST(DeviatingJoints, areThoseWithACauseOrInAChainWithOne) {
  const Mechanism robot = pendulums(3);
  const Evidence evidence = withFriction(robot, 1);
  const DeviatingJoints deviating{Evaluator(robot, evidence)};
  EXPECT_TRUE(deviating.any);
  EXPECT_EQ(deviating.joint, (std::vector{true, false, false}));
  EXPECT_EQ(deviating.chain, (std::vector{true, false, false}));
  EXPECT_EQ(deviating.weak, (std::vector{true, false, false}));
}

TEST(DeviatingJoints, noneWhereNothingIsMissing) {
  const Mechanism robot = pendulums(3);
  const Evidence evidence = withFriction(robot, 0);
  const DeviatingJoints deviating{Evaluator(robot, evidence)};
  EXPECT_FALSE(deviating.any);
  EXPECT_EQ(deviating.joint, std::vector(3, false));
}

}  // namespace
}  // namespace plumbline::gap
