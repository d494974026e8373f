#include "walking/engine/ServoLead.h"

#include <gtest/gtest.h>

#include "robot/MechanismFile.h"
#include "walking/engine/WalkEngine.h"

namespace plumbline::walking {
namespace {

class ServoLeadTest : public testing::Test {
protected:
  ServoLeadTest() {
    p.posture.hipHeight = 0.22;
    const WalkOutput stand = WalkEngine(p, lead.humanoid().model()).stand();
    angles = stand.angles;
    set = stand.set;
    p.servo.loadLead = p.servo.rateLead = 0;
  }
  double target(const char* joint) {
    const ServoCommand& command = lead.command({angles, set, stiffness, leftShare}, p, Vec2::Zero(), 0.01);
    return command.target[static_cast<std::size_t>(nao.requireJoint(joint))];
  }

  const Mechanism nao = findMechanism("nao_v5");
  ServoLead lead{nao};
  WalkParameters p;
  JointArray angles{}, stiffness = WalkOutput::fullStiffness();
  JointFlags set{};
  double leftShare = 0.5;
};

TEST_F(ServoLeadTest, aMovingTargetLeadsByTheServosLag) {
  p.servo.rateLead = 1;
  const double still = target("LKneePitch");
  EXPECT_EQ(still, angles[lKneePitch]);
  angles[lKneePitch] += 0.01;
  const Mechanism::Joint& knee = nao.joints[static_cast<std::size_t>(nao.requireJoint("LKneePitch"))];
  const double lag = (knee.servo.kd + knee.damping) / knee.servo.kp;
  EXPECT_NEAR(target("LKneePitch"), still + 0.01 + lag * 0.01 / 0.01, 1e-12);
  lead.reset();
  EXPECT_EQ(target("LKneePitch"), angles[lKneePitch]) << "nothing is known of the speed";
}

TEST_F(ServoLeadTest, theLoadedFootLeadsMoreAndTheShareTakesThreeCycles) {
  p.servo.loadLead = 1;
  const double half = target("LKneePitch") - angles[lKneePitch];
  leftShare = 1;
  double before = half;
  for (int i = 0; i < 3; ++i) {
    const double now = target("LKneePitch") - angles[lKneePitch];
    if (i < 2) {
      EXPECT_GT(std::abs(now), std::abs(before)) << i;
    }
    before = now;
  }
  EXPECT_EQ(target("LKneePitch") - angles[lKneePitch], before) << "all of the weight is on it";
  EXPECT_NEAR(before / half, 2, 0.3);
}

TEST_F(ServoLeadTest, targetsStayWithinTheStopsAndJointsThatAreNotSetGoToZero) {
  angles[lKneePitch] = 9;
  const Mechanism::Joint& knee = nao.joints[static_cast<std::size_t>(nao.requireJoint("LKneePitch"))];
  EXPECT_EQ(target("LKneePitch"), knee.upper);
  angles[headYaw] = 0.5;
  EXPECT_EQ(target("HeadYaw"), 0);
}

}  // namespace
}  // namespace plumbline::walking
