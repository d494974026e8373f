#include "gap/report/NextMotion.h"

#include <gtest/gtest.h>

#include "gap/TwoJointArm.h"
#include "gap/record/ExcitationFile.h"

namespace plumbline::gap {
namespace {

Cause causeAt(const Mechanism& robot, const char* id, const std::string& at, double value) {
  const Effect* effect = findEffect(id);
  return {effect, findPlace(*effect, robot, at, ""), value, 0};
}

TEST(NextMotion, FindsThatDampingAndFrictionDifferAtTheTorqueLimitAlone) {
  // tau = -kd w either way, but the servo's own damping is cut off with the rest of its torque.
  const Mechanism robot = twoJointArm();
  const std::string joint = robot.joints[1].name;
  const Cause damping = causeAt(robot, "servo_damping", joint, 1.5);
  const Cause friction = causeAt(robot, "viscous_friction", joint, 0.5 * robot.joints[1].servo.kd);
  const NextMotion next = findNextMotion(robot, {{damping}, {friction}});
  EXPECT_GT(next.best.separation, 1);
  EXPECT_TRUE(next.best.name.starts_with("steps") || next.best.name.starts_with("fast")) << next.best.name;
  for (const MotionScore& other : next.others)
    if (other.name.starts_with("triangle") || other.name.starts_with("reversals")) {
      EXPECT_LT(other.separation, 0.01) << other.name;
    }
}

TEST(NextMotion, TakesTheBestOfAllItTried) {
  const Mechanism robot = twoJointArm();
  const std::string joint = robot.joints[1].name;
  const NextMotion next = findNextMotion(
      robot, {{causeAt(robot, "backlash", joint, 0.03)}, {causeAt(robot, "coulomb_friction", joint, 0.1)}});
  ASSERT_GE(next.others.size(), 10U);
  EXPECT_GE(next.best.separation, next.others.front().separation);
  for (std::size_t i = 1; i < next.others.size(); ++i)
    EXPECT_GE(next.others[i - 1].separation, next.others[i].separation);
  EXPECT_EQ(next.program.name, next.best.name);
  EXPECT_GT(next.program.duration, 10);
}

TEST(NextMotion, AnEffectIsNoRivalOfItself) {
  const Mechanism robot = twoJointArm();
  const std::string joint = robot.joints[0].name;
  const NextMotion next = findNextMotion(robot, {{causeAt(robot, "coulomb_friction", joint, 0.1)},
                                                 {causeAt(robot, "coulomb_friction", joint, 0.1)}});
  EXPECT_LT(next.best.separation, 1e-6);
  EXPECT_THROW(findNextMotion(robot, {{causeAt(robot, "backlash", joint, 0.1)}}), std::invalid_argument);
}

TEST(NextMotion, SaysItInASentence) {
  const Mechanism robot = twoJointArm();
  const std::string joint = robot.joints[1].name;
  const std::string text = nextMotion(robot, causeAt(robot, "backlash", joint, 0.03),
                                      causeAt(robot, "viscous_friction", joint, 0.1));
  EXPECT_TRUE(text.starts_with("Record ")) << text;
  EXPECT_NE(text.find("backlash at " + joint + " and viscous_friction at " + joint + " differ by "),
            std::string::npos)
      << text;
}

}  // namespace
}  // namespace plumbline::gap
