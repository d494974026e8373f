#include "servo/RobotSimulation.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "math/Angle.h"
#include "robot/MechanismFile.h"

namespace plumbline::servo {
namespace {

std::string refusal(const std::string& engine, const std::vector<std::string>& others = {}) {
  try {
    RobotSimulations::require(engine, others);
  } catch (const std::invalid_argument& error) {
    return error.what();
  }
  return "no error";
}

bool has(const std::string& engine) {
  const std::vector<std::string> names = RobotSimulations::names();
  return std::find(names.begin(), names.end(), engine) != names.end();
}

TEST(RobotSimulations, anUnknownEngineIsRefusedByName) {
  EXPECT_EQ(refusal("bullet"), "no error");
  EXPECT_EQ(refusal("bulet"), "there is no engine bulet; did you mean \"bullet\"?");
  EXPECT_EQ(refusal("replay", {"replay"}), "no error");
  if (has("mujoco")) return;
  EXPECT_EQ(refusal("mujoco"),
            "engine mujoco is not in this program: install libmujoco-dev, configure and build again; there "
            "are: bullet");
  EXPECT_EQ(refusal("havok"), "there is no engine havok; there are: bullet");
}

/// Each engine of this program.
class AnyEngine : public testing::TestWithParam<std::string> {
protected:
  static std::unique_ptr<RobotSimulation> make(const Mechanism& robot,
                                               const RobotSimulationOptions& options = {}) {
    return RobotSimulations::make(GetParam(), robot, options);
  }
  const Mechanism nao = findMechanism("nao_v5");
  const std::vector<double> straight = std::vector<double>(nao.joints.size(), 0);
};

TEST_P(AnyEngine, aNaoStandsAndFeelsItsWeight) {
  const auto robot = make(nao);
  robot->restart(straight, 0.5);
  for (int i = 0; i < 200; ++i) robot->step();
  EXPECT_NEAR(robot->time(), 200 / nao.controlHz, 1e-9);
  EXPECT_GT(robot->base().pose.linear()(2, 2), std::cos(0.0873)) << "upright to 5 degrees";
  EXPECT_NEAR(std::atan2(robot->base().pose.linear()(1, 0), robot->base().pose.linear()(0, 0)), 0.5, 0.02);
  double weight = 0;
  for (const std::vector<double>& foot : robot->readings().footForce)
    for (const double force : foot) weight += force;
  EXPECT_NEAR(weight, 9.81 * nao.totalMass(), 1);
  EXPECT_NEAR(robot->readings().acc.norm(), 9.81, 0.1);
  EXPECT_LT(robot->comVelocity().norm(), 0.01);
}

TEST_P(AnyEngine, commandsPushesAndStiffnessAct) {
  RobotSimulationOptions options;
  options.fixedBase = true;
  const auto robot = make(nao, options);
  const auto head = static_cast<std::size_t>(nao.jointIndex("HeadYaw"));
  robot->restart(translation(0, 0, 2), straight);
  std::vector<double> targets = straight;
  targets[head] = 0.5;
  robot->command(targets);
  for (int i = 0; i < 100; ++i) robot->step();
  EXPECT_NEAR(robot->encoder(static_cast<int>(head)), 0.5, 0.02);
  EXPECT_NEAR(robot->base().pose.translation().z(), 2, 1e-9) << "its base is fixed";
  robot->setStiffness(0);
  robot->load(static_cast<int>(head), 0.2);
  for (int i = 0; i < 10; ++i) robot->step();
  EXPECT_GT(robot->encoder(static_cast<int>(head)), 0.55) << "what is soft gives way";
  targets[head] = NAN;
  EXPECT_THROW(robot->command(targets), std::invalid_argument);
  EXPECT_THROW(robot->command({}), std::invalid_argument);
  EXPECT_THROW(robot->restart({}, 0), std::invalid_argument);

  const auto free = make(nao);
  free->restart(straight, 0);
  free->push(Vec3(0, 150, 0), 0.2, 0);
  for (int i = 0; i < 100; ++i) free->step();
  EXPECT_GT(free->base().pose.translation().y(), 0.05) << "it was pushed to the left";
}

TEST_P(AnyEngine, theSameCallsGiveTheSameBytes) {
  const auto story = [this](RobotSimulation& robot) {
    robot.restart(straight, 0);
    std::vector<double> targets = straight;
    for (int i = 0; i < 60; ++i) {
      targets[static_cast<std::size_t>(nao.jointIndex("LShoulderPitch"))] = std::sin(0.2 * i);
      robot.command(targets);
      robot.step();
    }
    return robot.base().pose.matrix();
  };
  const auto one = make(nao), two = make(nao);
  const Eigen::Matrix4d first = story(*one);
  EXPECT_EQ(first, story(*two));
  EXPECT_EQ(first, story(*one)) << "nothing is left of what was before";
}

TEST(RobotSimulations, aSecondEngineOfTheSameNameEndsTheProgram) {
  EXPECT_EXIT(RobotSimulations::add("bullet", nullptr), testing::ExitedWithCode(2),
              "^two engines for servo robots with the name bullet are linked into this program\n$");
}

INSTANTIATE_TEST_SUITE_P(Engines, AnyEngine, testing::ValuesIn(RobotSimulations::names()),
                         [](const auto& info) { return info.param; });

}  // namespace
}  // namespace plumbline::servo
