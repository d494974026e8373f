#include "gap/report/MotionDesigns.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "robot/MechanismFile.h"

namespace plumbline::gap {
namespace {

TEST(MotionDesigns, lastAboutFourteenSecondsWithRestAtBothEnds) {
  const Mechanism robot = findMechanism("so101");
  const std::vector<Excitation> designs = motionDesigns(robot, {robot.jointIndex("Elbow")});
  EXPECT_EQ(designs.size(), 18U);
  for (const Excitation& design : designs) {
    SCOPED_TRACE(design.name);
    EXPECT_GT(design.duration, 10);
    EXPECT_LT(design.duration, 20);
    const CommandTable table = playExcitation(design, robot, 100);
    const std::vector<double>& command = table.commands[static_cast<std::size_t>(robot.jointIndex("Elbow"))];
    const auto same = [](double a, double b) { return std::abs(a - b) < 1e-6; };
    EXPECT_TRUE(std::equal(command.begin(), command.begin() + 35, command.begin() + 1, same));
    EXPECT_TRUE(std::equal(command.end() - 46, command.end() - 1, command.end() - 45, same));
    EXPECT_FALSE(std::equal(command.begin(), command.end() - 1, command.begin() + 1, same));
  }
  for (const Excitation& design : designs) {
    if (design.name == "poses" || design.name.starts_with("reversals")) continue;
    EXPECT_NEAR(design.duration, 13.9, 0.3) << design.name;
  }
}

TEST(MotionDesigns, sayWhatTheyAreAndOfWhichJoints) {
  const Mechanism robot = findMechanism("so101");
  const std::vector<Excitation> designs = motionDesigns(robot, {0, 1});
  EXPECT_EQ(designs[0].about, "next_triangle20: slow triangles of Rotation, Pitch");
  EXPECT_EQ(motionDesigns(robot, {0, 1, 2, 3, 4})[0].about, "next_triangle20: slow triangles of 5 joints");
}

}  // namespace
}  // namespace plumbline::gap
