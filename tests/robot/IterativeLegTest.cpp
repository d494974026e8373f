#include "robot/IterativeLeg.h"

#include <gtest/gtest.h>

#include <random>

#include "math/Index.h"
#include "robot/ClosedFormLeg.h"
#include "robot/HumanoidModel.h"
#include "robot/LegKinematics.h"
#include "robot/MechanismFile.h"
#include "support/Thrown.h"

namespace plumbline {
namespace {

const RobotModel& offsetHips() {
  static const RobotModel robot = Humanoid(readMechanism("tests/data/robots/waist_and_arms.json")).model();
  return robot;
}
const RobotModel& nao() {
  static const RobotModel robot = Humanoid(findMechanism("nao_v5")).model();
  return robot;
}

class RandomLeg {
public:
  RandomLeg(const RobotModel& robot, Side side, unsigned seed)
      : robot_(robot), first_(firstLegJoint(side)), random_(seed) {}
  LegAngles angles() {
    LegAngles q;
    for (std::size_t i = 0; i < 6; ++i) {
      const Link& link = robot_.linkMovedBy(static_cast<JointId>(first_ + static_cast<int>(i)));
      q[i] = std::uniform_real_distribution(link.lower, link.upper)(random_);
    }
    return q;
  }

private:
  const RobotModel& robot_;
  int first_;
  std::mt19937 random_;
};

double apart(const Pose3& a, const Pose3& b) {
  const Eigen::AngleAxisd turn(Mat3(a.linear() * b.linear().transpose()));
  return std::hypot((a.translation() - b.translation()).norm(), turn.angle());
}

TEST(IterativeLeg, reachesEveryPoseOfAHipWhoseAxesDoNotMeet) {
  for (const Side side : {Side::left, Side::right}) {
    const IterativeLeg leg(offsetHips(), side);
    RandomLeg random(offsetHips(), side, 11);
    for (int n = 0; n < 1000; ++n) {
      const Pose3 wanted = leg.foot(random.angles());
      const LegSolution solution = leg.solve(wanted);
      ASSERT_TRUE(solution.reachable) << n;
      ASSERT_LT(apart(leg.foot(solution.angles), wanted), 1e-8) << n;
    }
  }
}

TEST(IterativeLeg, agreesWithTheClosedFormOnTheNao) {
  for (const Side side : {Side::left, Side::right}) {
    const IterativeLeg iterative(nao(), side);
    const ClosedFormLeg closed(nao(), side);
    EXPECT_LT((iterative.hip() - closed.hip()).norm(), 1e-9);
    EXPECT_NEAR(iterative.ankleHeight(), closed.ankleHeight(), 1e-12);
    EXPECT_NEAR(iterative.maxReach(), closed.maxReach(), 1e-3);
    RandomLeg random(nao(), side, 12);
    for (int n = 0; n < 300; ++n) {
      LegAngles q = random.angles();
      q[3] = std::max(q[3], 0.2);  // a nearly straight leg has two solutions close to each other
      const Pose3 wanted = closed.foot(q);
      EXPECT_LT(apart(iterative.foot(q), wanted), 1e-12);
      const LegSolution solution = iterative.solve(wanted), same = closed.solve(wanted);
      ASSERT_TRUE(solution.reachable) << n;
      ASSERT_LT(apart(iterative.foot(solution.angles), closed.foot(same.angles)), 2e-8) << n;
      for (std::size_t i = 0; i < 6; ++i)
        ASSERT_NEAR(solution.angles[i], same.angles[i], 1e-6) << n << " " << i;
    }
  }
}

TEST(IterativeLeg, solvesForAGivenHipYawPitchAsTheClosedFormDoes) {
  const IterativeLeg iterative(nao(), Side::left);
  const ClosedFormLeg closed(nao(), Side::left);
  for (const double given : {-0.4, 0.0, 0.1}) {
    const Pose3 wanted = translation(0.03, 0.06, -0.085 - 0.17) * rotationY(0.08) * rotationX(0.05);
    const LegSolution one = iterative.solve(wanted, given), other = closed.solve(wanted, given);
    ASSERT_TRUE(one.reachable) << given;
    EXPECT_EQ(one.angles[0], given);
    for (std::size_t i = 0; i < 6; ++i)
      EXPECT_NEAR(one.angles[i], other.angles[i], 1e-7) << given << " " << i;
  }
}

TEST(IterativeLeg, outOfReachItComesNearWithinItsLimits) {
  const IterativeLeg leg(offsetHips(), Side::left);
  const Pose3 straight = leg.foot({});
  const LegSolution far = leg.solve(translation(0, 0, -0.1) * straight);
  EXPECT_FALSE(far.reachable);
  EXPECT_LT(leg.foot(far.angles).translation().z(), straight.translation().z() + 0.002);
  const LegSolution given = leg.solve(straight, 2.0);
  EXPECT_FALSE(given.reachable) << "the hip yaw does not turn so far";
  EXPECT_EQ(given.angles[0], 0.8);
}

TEST(IterativeLeg, theSameQuestionHasTheSameAnswer) {
  const IterativeLeg leg(offsetHips(), Side::right);
  const Pose3 wanted = leg.foot({0.1, -0.1, -0.5, 0.9, -0.4, 0.05});
  const LegAngles before = leg.solve(wanted).angles;
  leg.solve(translation(0.02, 0, 0.03) * wanted);
  EXPECT_EQ(leg.solve(wanted).angles, before);
}

TEST(LegChain, aMissingJointIsNamed) {
  for (const JointId missing : {lKneePitch, lAnkleRoll}) {
    RobotModel robot = nao();
    robot.linkOfJoint[missing] = -1;
    try {
      LegKinematics leg(robot, Side::left);
      FAIL();
    } catch (const std::invalid_argument& error) {
      EXPECT_EQ(error.what(), "robot nao_v5: the leg has no " + std::string(robot.jointName(missing)) +
                                  " between torso and foot; leg kinematics needs the six joints from "
                                  "LHipYawPitch to LAnkleRoll");
    }
  }
  // The robot has a knee, but the shank hangs on the hip beside it.
  RobotModel robot = nao();
  Link& shank = robot.links[at(robot.linkOfJoint[lAnklePitch])];
  shank.parent = robot.linkOfJoint[lHipPitch];
  EXPECT_EQ(thrownBy([&] { LegChain(robot, Side::left); }),
            "robot nao_v5: the leg has no LKneePitch between torso and foot; leg kinematics needs the six "
            "joints from LHipYawPitch to LAnkleRoll");
  const RobotModel quadruped = Humanoid(readMechanism("tests/data/robots/quadruped.json")).model();
  EXPECT_THROW(LegKinematics(quadruped, Side::right), std::invalid_argument);
}

}  // namespace
}  // namespace plumbline
