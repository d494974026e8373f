#include "simspark/JointNames.h"

#include <gtest/gtest.h>

#include <string>

namespace plumbline::simspark {
namespace {

TEST(JointNames, everyJointIsFoundByItsNames) {
  for (int i = 0; i < numHumanoidJoints; ++i) {
    const auto joint = static_cast<JointId>(i);
    EXPECT_EQ(jointByPerceptor(simsparkName(joint).perceptor), joint);
    EXPECT_EQ(jointByEffector(simsparkName(joint).effector), joint);
    EXPECT_EQ(jointByEffector(simsparkName(joint).perceptor), noJoint);
    EXPECT_EQ(jointByPerceptor(simsparkName(joint).effector), noJoint);
  }
}

TEST(JointNames, pitchAxesPointTheOtherWay) {
  for (int i = 0; i < numHumanoidJoints; ++i) {
    const bool pitch = humanoidJointNames[std::size_t(i)].ends_with("Pitch") &&
                       !humanoidJointNames[std::size_t(i)].ends_with("YawPitch");
    EXPECT_EQ(simsparkName(static_cast<JointId>(i)).sign, pitch ? -1 : 1)
        << humanoidJointNames[std::size_t(i)];
  }
  EXPECT_EQ(jointByPerceptor("rlj4"), rKneePitch);
  EXPECT_EQ(jointByPerceptor("llj1"), lHipYawPitch);
  EXPECT_EQ(jointByEffector("lae3"), lElbowYaw);
}

TEST(JointNames, nothingElseIsAJoint) {
  for (const char* name : {"", "h", "hj", "hj0", "hj3", "hj12", "raj0", "raj5", "rlj8", "rlj0", "xlj1",
                           "rxj1", "llj", "rlj1x", "HJ1", "rlj\xff", "rlj:"})
    EXPECT_EQ(jointByPerceptor(name), noJoint) << name;
}

}  // namespace
}  // namespace plumbline::simspark
