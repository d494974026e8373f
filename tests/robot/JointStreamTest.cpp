#include "robot/JointStream.h"

#include <gtest/gtest.h>

#include "framework/BinaryStream.h"
#include "robot/HumanoidModel.h"
#include "robot/MechanismFile.h"

namespace plumbline {
namespace {

JointArray counted() {
  JointArray values;
  for (std::size_t j = 0; j < maxJoints; ++j) values[j] = static_cast<double>(j);
  return values;
}

struct JointStream : testing::Test {
  ~JointStream() override { streamJointsOf(RobotModel()); }
};

TEST_F(JointStream, carriesAHumanoidsJointsAsAnArrayOf24) {
  std::array<double, numHumanoidJoints> same;
  for (std::size_t j = 0; j < same.size(); ++j) same[j] = static_cast<double>(j);
  EXPECT_EQ(toBinary(counted()), toBinary(same));
}

TEST_F(JointStream, carriesTheRobotsOwnJointsBehindThem) {
  streamJointsOf(Humanoid(findMechanism("nao_v5")).model());
  ASSERT_EQ(streamedJoints().size(), 26u);
  JointArray read{};
  EXPECT_EQ(fromBinary(toBinary(counted()), read), "");
  EXPECT_EQ(read[rToePitch], rToePitch);
  EXPECT_EQ(read[54], 54);
  EXPECT_EQ(read[59], 59);
  EXPECT_EQ(read[60], 0);
}

}  // namespace
}  // namespace plumbline
