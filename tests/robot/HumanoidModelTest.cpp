#include "robot/HumanoidModel.h"

#include <gtest/gtest.h>

#include "math/Angle.h"
#include "robot/ForwardKinematics.h"
#include "robot/LegKinematics.h"
#include "robot/MechanismFile.h"

namespace plumbline {
namespace {

class NaoModel : public testing::Test {
protected:
  const Mechanism nao = findMechanism("nao_v5");
  const Humanoid humanoid{nao};
  const RobotModel& model = humanoid.model();
};

TEST_F(NaoModel, hasTheJointsByName) {
  EXPECT_EQ(model.links.size(), 25u);  // torso and 24 joints, of which the wrists are the robot's own
  EXPECT_EQ(model.numJoints(), 24);
  EXPECT_EQ(humanoid.mechanismJoint(model.requireJoint("RWristYaw")), nao.jointIndex("RWristYaw"));
  EXPECT_FALSE(model.has(lToePitch));
  EXPECT_EQ(humanoid.mechanismJoint(rKneePitch), nao.jointIndex("RKneePitch"));
  EXPECT_EQ(humanoid.mechanismJoint(lToePitch), -1);
  EXPECT_TRUE(model.sharedHipYawPitch);
  EXPECT_NEAR(model.totalMass(), nao.totalMass(), 1e-12);
}

TEST_F(NaoModel, movesItsMassAsTheMechanismDoes) {
  std::vector<double> q;
  for (const Mechanism::Joint& joint : nao.joints) q.push_back(0.3 * joint.lower + 0.7 * joint.upper);
  const Vec3 expected = centreOfMass(nao, linkPoses(nao, q));
  ForwardKinematics kinematics(model);
  kinematics.update(humanoid.toModel(q));
  EXPECT_LT((kinematics.com() - expected).norm(), 1e-12);
}

TEST_F(NaoModel, whatSlidesIsPartOfTheLinkThatCarriesIt) {
  Mechanism gripping = nao;
  for (const char* name : {"LWristYaw", "RWristYaw"})
    gripping.joints[static_cast<std::size_t>(gripping.requireJoint(name))].type =
        Mechanism::Joint::Type::prismatic;
  const Humanoid other(gripping);
  EXPECT_FALSE(other.model().joint("LWristYaw"));
  const Mechanism::Joint& wrist =
      gripping.joints[static_cast<std::size_t>(gripping.requireJoint("LWristYaw"))];
  const Mechanism::Link& arm = gripping.links[static_cast<std::size_t>(wrist.parent)];
  const Mechanism::Link& hand = gripping.links[static_cast<std::size_t>(wrist.child)];
  const Link& both = other.model().links[static_cast<std::size_t>(other.model().linkOfJoint[lElbowRoll])];
  // Of a rigid body about a point: what its parts have about the point.
  const auto aboutOrigin = [](const Mat3& inertia, double mass, const Vec3& com) {
    return Mat3(inertia + mass * (com.squaredNorm() * Mat3::Identity() - com * com.transpose()));
  };
  const Vec3 handCom = wrist.origin + hand.com;
  EXPECT_NEAR(both.mass, arm.mass + hand.mass, 1e-12);
  EXPECT_LT((both.mass * both.com - arm.mass * arm.com - hand.mass * handCom).norm(), 1e-12);
  EXPECT_LT((aboutOrigin(both.inertia, both.mass, both.com) - aboutOrigin(arm.inertia, arm.mass, arm.com) -
             aboutOrigin(hand.inertia, hand.mass, handCom))
                .norm(),
            1e-12);
}

TEST_F(NaoModel, valuesGoToTheMechanismAndBack) {
  JointArray values{};
  for (const JointId joint : model.joints()) values[joint] = 1 + joint;
  const std::vector<double> there = humanoid.toMechanism(values);
  EXPECT_EQ(there.size(), nao.joints.size());
  EXPECT_EQ(there[static_cast<std::size_t>(nao.jointIndex("LWristYaw"))], 1 + 54);
  EXPECT_EQ(humanoid.toModel(there), values);
}

TEST_F(NaoModel, soleIsTheBoxOfTheFile) {
  const LegKinematics leg(model, Side::left);
  EXPECT_NEAR(leg.ankleHeight(), 0.0452, 1e-9);
  EXPECT_NEAR(leg.T_foot_sole().translation().x(), 0.02, 1e-12);
  EXPECT_NEAR(leg.soleHalfSize().x(), 0.08, 1e-12);
}

TEST_F(NaoModel, legWithAGivenHipYawPitchPutsTheSoleWhereItShall) {
  for (const Side side : {Side::left, Side::right}) {
    const LegKinematics leg(model, side);
    const double y = side == Side::left ? 0.05 : -0.05;
    for (const double given : {-0.4, 0.0, 0.1}) {
      const Pose3 wanted = translation(0.03, 1.2 * y, -0.085 - 0.21) * rotationY(0.08) * rotationX(0.05);
      const LegSolution solution = leg.solve(wanted, given);
      ASSERT_TRUE(solution.reachable);
      EXPECT_EQ(solution.angles[0], given);
      const Pose3 reached = leg.sole(solution.angles);
      const Pose3 T_sole_foot = leg.T_foot_sole().inverse();
      EXPECT_LT(((reached * T_sole_foot).translation() - (wanted * T_sole_foot).translation()).norm(), 1e-12)
          << "the ankle is where it shall be";
      EXPECT_LT((reached.linear().col(2) - wanted.linear().col(2)).norm(), 1e-12) << "the sole lies flat";
    }
    // With the hip yaw pitch of the full solution it is the full solution.
    const Pose3 turned = translation(0.02, 1.1 * y, -0.29) * rotationZ(4 * y);
    const LegSolution full = leg.solve(turned), same = leg.solve(turned, full.angles[0]);
    for (std::size_t i = 0; i < 6; ++i) EXPECT_NEAR(same.angles[i], full.angles[i], 1e-9) << i;
  }
}

TEST_F(NaoModel, aTurnedJointFrameIsAnError) {
  Mechanism turned = nao;
  turned.joints[3].rpy = Vec3(0.1, 0, 0);
  try {
    Humanoid refused(turned);
    FAIL();
  } catch (const std::invalid_argument& error) {
    EXPECT_STREQ(error.what(),
                 "robot nao_v5, joint LHipRoll: its frame is turned in its parent's; it must not be");
  }
}

}  // namespace
}  // namespace plumbline
