#include "robot/UrdfWriter.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "robot/HumanoidModel.h"
#include "robot/MechanismFile.h"
#include "robot/MechanismParts.h"

namespace plumbline {
namespace {

/// What is written is read again as the same robot.
void expectReadAgain(const std::string& name) {
  const RobotModel model = Humanoid(findMechanism(name)).model();
  const MechanismParts parts = partsOfUrdf(urdfOf(model), name + ".urdf");
  EXPECT_EQ(parts.name, model.name);
  ASSERT_EQ(parts.links.size(), model.links.size());
  for (std::size_t i = 0; i < model.links.size(); ++i) {
    const Link& link = model.links[i];
    const auto& again = parts.links[i];
    EXPECT_EQ(again.name, link.name);
    EXPECT_EQ(again.mass, link.mass) << link.name;
    EXPECT_EQ(again.com, link.com) << link.name;
    EXPECT_EQ(again.inertia, link.inertia) << link.name;
    if (link.joint == noJoint) continue;
    const auto joint = std::ranges::find_if(
        parts.joints, [&](const auto& j) { return j.joint.name == model.jointName(link.joint); });
    ASSERT_NE(joint, parts.joints.end()) << link.name;
    EXPECT_EQ(joint->joint.origin, link.origin) << link.name;
    EXPECT_EQ(joint->joint.axis, link.axis) << link.name;
    EXPECT_EQ(joint->joint.lower, link.lower) << link.name;
    EXPECT_EQ(joint->joint.upper, link.upper) << link.name;
  }
}

TEST(UrdfWriter, writesWhatIsReadAsTheSameRobot) {
  expectReadAgain("nao_v5");
  expectReadAgain("simspark_type4");
}

}  // namespace
}  // namespace plumbline
