#include "modules/modeling/ground/TorsoHeight.h"

#include <gtest/gtest.h>

#include <cmath>

#include "robot/ForwardKinematics.h"
#include "robot/HumanoidModel.h"
#include "robot/MechanismFile.h"
#include "simspark/LeagueRobots.h"

using namespace plumbline;

namespace {

std::vector<Pose3> linksOf(const RobotModel& model) {
  ForwardKinematics kinematics(model);
  kinematics.update(JointArray{});
  std::vector<Pose3> links;
  for (std::size_t i = 0; i < model.links.size(); ++i) links.push_back(kinematics.link(static_cast<int>(i)));
  return links;
}

// The heights at which the league's robots stand straight, from their scene files.
TEST(TorsoHeight, standingStraight) {
  const double expected[] = {0.385, 0.42164, 0.385, 0.440737, 0.385};
  for (int type = 0; type < numSimsparkTypes(); ++type) {
    const RobotModel model = simsparkRobot(type);
    const auto links = linksOf(model);
    EXPECT_NEAR(TorsoHeight(model).aboveFeet(Vec3::UnitZ(), links), expected[type], 1e-6) << "type " << type;
    EXPECT_NEAR(TorsoHeight(model).aboveLowestPoint(Vec3::UnitZ(), links), expected[type], 1e-6);
  }
}

// A file may name the feet's links as it likes: the NAO's are l_ankle and r_ankle, the quadruped's its
// shanks.
TEST(TorsoHeight, feetAreThoseOfTheFile) {
  const RobotModel nao = Humanoid(findMechanism("nao_v5")).model();
  // From hip, thigh, tibia and foot in Aldebaran's documentation.
  EXPECT_NEAR(TorsoHeight(nao).aboveFeet(Vec3::UnitZ(), linksOf(nao)), 0.085 + 0.1 + 0.1029 + 0.04519, 5e-4);
  const RobotModel quadruped = Humanoid(readMechanism("tests/data/robots/quadruped.json")).model();
  EXPECT_NEAR(TorsoHeight(quadruped).aboveFeet(Vec3::UnitZ(), linksOf(quadruped)), 0.15 + 0.15 + 0.015, 1e-9);
}

TEST(TorsoHeight, tiltedItStandsOnAnEdge) {
  const RobotModel model = simsparkRobot(0);
  const auto links = linksOf(model);
  const double tilt = 0.2;
  const Vec3 up = rotationX(tilt).linear().row(2);
  // Turned about x to the right: the right sole's outer edge is lowest, 0.055 + 0.04 from the middle.
  EXPECT_NEAR(TorsoHeight(model).aboveFeet(up, links), 0.385 * std::cos(tilt) + 0.095 * std::sin(tilt), 1e-9);
}

TEST(TorsoHeight, onItsBackItLiesOnTheHead) {
  const RobotModel model = simsparkRobot(0);
  EXPECT_NEAR(TorsoHeight(model).aboveLowestPoint(Vec3::UnitX(), linksOf(model)), 0.065, 0.005);
}

}  // namespace
