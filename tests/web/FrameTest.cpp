#include "web/Frame.h"

#include <gtest/gtest.h>

#include <cstring>

#include "framework/ConfigurationError.h"
#include "robot/RobotModel.h"
#include "simspark/LeagueRobots.h"
#include "simulation/monitor/SceneTexts.h"
#include "support/Samples.h"

namespace plumbline::web {
namespace {

using simspark::SceneState;

/// Reads a frame's fields one after the other.
struct Bytes {
  std::string text;
  std::size_t at = 0;
  template <class T>
  T get() {
    T value{};
    EXPECT_LE(at + sizeof value, text.size());
    std::memcpy(&value, text.data() + at, sizeof value);
    at += sizeof value;
    return value;
  }
};

TEST(SceneBodies, areThoseOfTheScene) {
  for (int type = 0; type < numSimsparkTypes(); ++type) {
    std::vector<std::string> links;
    for (const simulation::BodyLook& look : simulation::robotLooks(type)) links.push_back(look.link);
    EXPECT_EQ(simspark::sceneBodies(type), links) << type;
  }
  EXPECT_THROW(simspark::sceneBodies(5), ConfigurationError);
}

TEST(SceneBodies, ofTheLeaguesServer) {
  const auto messages = test::samples("monitor_two_agents");
  SceneState scene;
  for (const auto& message : messages) ASSERT_EQ(scene.update(message), "");
  for (const auto& robot : scene.robots) {
    ASSERT_EQ(robot.T_world_bodies.size(), simspark::sceneBodies(robot.type).size());
    EXPECT_TRUE(robot.T_world_bodies[0].isApprox(robot.T_world_torso));
    // Standing: the head is 0.155 m above the torso's middle, the feet below it, left and right as they are.
    const auto from = [&](std::size_t body) -> Vec3 {
      return robot.T_world_torso.inverse() * robot.T_world_bodies[body].translation();
    };
    EXPECT_NEAR(from(2).z(), 0.155, 0.01);
    const auto names = simspark::sceneBodies(robot.type);
    for (std::size_t i = 0; i < names.size(); ++i) {
      if (!names[i].ends_with("Foot")) continue;
      const double y = names[i] == "lFoot" ? 0.055 : -0.055;
      EXPECT_NEAR((from(i) - Vec3(0.02, y, -0.37)).norm(), 0, 0.03) << names[i];
    }
  }
}

TEST(Frame, toTheByte) {
  SceneState scene;
  scene.time = 12.5;
  scene.ball = Vec3(1, -2, 0.042);
  simspark::SceneRobot robot;
  robot.side = simspark::TeamSide::right;
  robot.unum = 7;
  robot.type = 4;
  robot.T_world_torso = translation(3, 4, 0.4);
  for (std::size_t i = 0; i < simspark::sceneBodies(4).size(); ++i)
    robot.T_world_bodies.push_back(translation(3 + 0.01 * static_cast<double>(i), 4, 0.3) * rotationZ(1));
  scene.robots.push_back(robot);
  robot.T_world_bodies.pop_back();
  scene.robots.push_back(robot);

  Bytes bytes{frameMessage(scene)};
  EXPECT_EQ(bytes.text.size(), frameHeaderBytes + 2 * frameRobotBytes + 25 * framePartBytes);
  EXPECT_EQ(bytes.get<std::uint8_t>(), 1);
  EXPECT_EQ(bytes.get<std::uint8_t>(), 2);
  EXPECT_EQ(bytes.get<std::uint16_t>(), 0);
  EXPECT_EQ(bytes.get<double>(), 12.5);
  EXPECT_EQ(bytes.get<float>(), 1);
  EXPECT_EQ(bytes.get<float>(), -2);
  EXPECT_EQ(bytes.get<float>(), 0.042f);
  for (const int q : {0, 0, 0, 32767}) EXPECT_EQ(bytes.get<std::int16_t>(), q);
  EXPECT_EQ(bytes.get<std::uint8_t>(), 2);
  EXPECT_EQ(bytes.get<std::uint8_t>(), 7);
  EXPECT_EQ(bytes.get<std::uint8_t>(), 4);
  EXPECT_EQ(bytes.get<std::uint8_t>(), 25);
  EXPECT_EQ(bytes.get<float>(), 3);
  EXPECT_EQ(bytes.get<float>(), 4);
  EXPECT_EQ(bytes.get<float>(), 0.4f);
  for (int i = 0; i < 25; ++i) {
    EXPECT_EQ(bytes.get<std::int16_t>(), 100 * i);
    EXPECT_EQ(bytes.get<std::int16_t>(), 0);
    EXPECT_EQ(bytes.get<std::int16_t>(), -1000);
    EXPECT_EQ(bytes.get<std::int16_t>(), 0);
    EXPECT_EQ(bytes.get<std::int16_t>(), 0);
    EXPECT_EQ(bytes.get<std::int16_t>(), 16 * std::lround(32767 * std::sin(0.5) / 16));
    EXPECT_EQ(bytes.get<std::int16_t>(), 16 * std::lround(32767 * std::cos(0.5) / 16));
  }
  EXPECT_EQ(bytes.get<std::uint8_t>(), 2);
  EXPECT_EQ(bytes.get<std::uint8_t>(), 7);
  EXPECT_EQ(bytes.get<std::uint8_t>(), 0);
  EXPECT_EQ(bytes.get<std::uint8_t>(), 0) << "bodies that are not those of its type are left out";
}

TEST(Frame, whatIsNoNumberOrFarAwayFitsAnyway) {
  SceneState scene;
  simspark::SceneRobot robot;
  robot.type = 9;
  scene.robots.assign(300, robot);
  robot.type = 0;
  robot.T_world_bodies.assign(simspark::sceneBodies(0).size(), translation(1e6, 0, 0));
  robot.T_world_bodies[3].linear().setZero();
  scene.robots[0] = robot;
  Bytes bytes{frameMessage(scene)};
  EXPECT_EQ(bytes.text.size(), frameHeaderBytes + 255 * frameRobotBytes + 23 * framePartBytes);
  bytes.at = frameHeaderBytes + frameRobotBytes;
  EXPECT_EQ(bytes.get<std::int16_t>(), 32767);
}

}  // namespace
}  // namespace plumbline::web
