#include "gap/record/Postures.h"

#include <gtest/gtest.h>

#include "robot/MechanismFile.h"
#include "support/ScratchFolder.h"
#include "support/Thrown.h"

namespace plumbline::gap {
namespace {

double angleOf(const std::string& joint, const std::vector<double>& posture, const Mechanism& robot) {
  return posture.at(static_cast<std::size_t>(robot.requireJoint(joint)));
}

TEST(Postures, areInTheRobotsOwnFileOrInTheOneForAll) {
  for (const char* name : {"nao_v5", "simspark_type2"}) {
    const Mechanism robot = findMechanism(name);
    const auto stand = namedPosture("stand", robot);
    ASSERT_TRUE(stand) << name;
    EXPECT_GT(angleOf("LKneePitch", *stand, robot), 0.8) << name;
    EXPECT_EQ(angleOf("HeadYaw", *stand, robot), 0) << name;
    EXPECT_FALSE(namedPosture("sit", robot)) << name;
  }
}

TEST(Postures, ofARobotThatHasNoneAreNeutral) {
  const Mechanism robot = findMechanism("xl330_pendulum");
  EXPECT_EQ(namedPosture("hang", robot), neutralPosture(robot));
  EXPECT_FALSE(namedPosture("stand", robot));
}

TEST(Postures, ofTheProgramsFolderComeFirst) {
  const test::ScratchFolder scratch;
  const std::string folder = scratch.path();
  scratch.write("postures.yaml", "nao_v5: {sit: {LKneePitch: 1.5}}\n");
  const Mechanism nao = findMechanism("nao_v5"), arm = findMechanism("so101");
  EXPECT_EQ(angleOf("LKneePitch", *namedPosture("sit", nao, folder), nao), 1.5);
  EXPECT_FALSE(namedPosture("stand", nao, folder)) << "the folder has all of this robot";
  EXPECT_EQ(namedPosture("hang", arm, folder), namedPosture("hang", arm)) << "and nothing of that one";
  scratch.write("postures.yaml", "nao_v5: {sit: {LKnePitch: 1.5}}\n");
  EXPECT_EQ(
      thrownBy([&] { namedPosture("sit", nao, folder); }),
      folder + "/postures.yaml:1: nao_v5.sit.LKnePitch is no joint of nao_v5; did you mean \"LKneePitch\"?");
}

}  // namespace
}  // namespace plumbline::gap
