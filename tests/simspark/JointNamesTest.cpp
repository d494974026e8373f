#include "simspark/JointNames.h"

#include <gtest/gtest.h>

#include <string>

namespace plumbline::simspark {
namespace {

TEST(JointNames, everyJointIsFoundByItsNames) {
  for (int i = 0; i < numJoints; ++i) {
    const auto joint = static_cast<JointId>(i);
    EXPECT_EQ(jointByPerceptor(simsparkName(joint).perceptor), joint);
    EXPECT_EQ(jointByEffector(simsparkName(joint).effector), joint);
    EXPECT_EQ(jointByEffector(simsparkName(joint).perceptor), numJoints);
    EXPECT_EQ(jointByPerceptor(simsparkName(joint).effector), numJoints);
  }
}

TEST(JointNames, pitchAxesPointTheOtherWay) {
  for (int i = 0; i < numJoints; ++i) {
    const bool pitch =
        jointNames[std::size_t(i)].ends_with("Pitch") && !jointNames[std::size_t(i)].ends_with("YawPitch");
    EXPECT_EQ(simsparkName(static_cast<JointId>(i)).sign, pitch ? -1 : 1) << jointNames[std::size_t(i)];
  }
  EXPECT_EQ(jointByPerceptor("rlj4"), rKneePitch);
  EXPECT_EQ(jointByPerceptor("llj1"), lHipYawPitch);
  EXPECT_EQ(jointByEffector("lae3"), lElbowYaw);
}

TEST(JointNames, nothingElseIsAJoint) {
  for (const char* name : {"", "h", "hj", "hj0", "hj3", "hj12", "raj0", "raj5", "rlj8", "rlj0", "xlj1",
                           "rxj1", "llj", "rlj1x", "HJ1", "rlj\xff", "rlj:"})
    EXPECT_EQ(jointByPerceptor(name), numJoints) << name;
}

}  // namespace
}  // namespace plumbline::simspark
