#include "simspark/PerceptLimits.h"

#include <gtest/gtest.h>

#include <limits>

namespace plumbline::simspark {
namespace {

TEST(PerceptLimits, leavesAMessageThatCanBeAsItIs) {
  ServerMessage message, before;
  message.gyro = Vec3(3, -20, 5);
  message.acc = Vec3(0, 0, 9.81);
  message.angle[headYaw] = 2;
  message.see.emplace();
  message.see->objects.push_back({"B", {12, 1, -0.2}});
  std::string first;
  EXPECT_EQ(dropImplausible(message, before, first), 0);
  EXPECT_EQ(first, "");
  EXPECT_EQ(message.gyro, Vec3(3, -20, 5));
  EXPECT_EQ(message.see->objects.size(), 1u);
}

TEST(PerceptLimits, dropsEachPerceptAloneAndNamesTheFirst) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  ServerMessage message, before;
  before.acc = Vec3(1, 2, 9);
  before.leftFoot = ForceReading{Vec3(0, 0, 0.1), Vec3(0, 0, 40)};
  message.gyro = Vec3(1, 0, 0);
  message.acc = Vec3(0, nan, 9.81);
  message.angle[headYaw] = 1e160;
  message.angle[headPitch] = 0.5;
  message.leftFoot = ForceReading{Vec3::Zero(), Vec3(0, 0, -1e200)};
  message.see.emplace();
  message.see->objects = {{"B", {1e100, 0, 0}}, {"F1L", {8, 0, 0}}};
  message.see->lines = {{{1, 0, 0}, {2, 1e9, 0}}, {{1, 0, 0}, {2, 1, 0}}};
  message.see->players = {{"Them", 3, {{"head", {3, 0, nan}}, {"lfoot", {3, 0, 0}}}}};
  message.heard = {{"Them", 1, false, 1e300, "x"}, {"Them", 1, false, 1, "y"}};
  std::string first;
  EXPECT_EQ(dropImplausible(message, before, first), 7);
  EXPECT_EQ(first, "angle of hj1");
  EXPECT_FALSE(message.angle[headYaw]);
  EXPECT_EQ(message.angle[headPitch], 0.5);
  EXPECT_EQ(message.gyro, Vec3(1, 0, 0));
  EXPECT_EQ(message.acc, Vec3(1, 2, 9)) << "of the message before";
  EXPECT_EQ(message.leftFoot->force.z(), 40);
  ASSERT_EQ(message.see->objects.size(), 1u);
  EXPECT_EQ(message.see->objects[0].name, "F1L");
  EXPECT_EQ(message.see->lines.size(), 1u);
  EXPECT_EQ(message.see->players[0].parts.size(), 1u);
  ASSERT_EQ(message.heard.size(), 1u);
  EXPECT_EQ(message.heard[0].text, "y");
}

}  // namespace
}  // namespace plumbline::simspark
