#include "gap/replay/TrialOf.h"

#include <gtest/gtest.h>

#include "../OneJoint.h"

namespace plumbline::gap {
namespace {

/// A run of one joint over two seconds.
Run runWith(const std::string& column, const std::function<double(double)>& sent) {
  Run run;
  run.folder = "r";
  run.robot = "one_joint";
  for (int k = 0; k < 200; ++k) {
    run.t.push_back(0.01 * k);
    run.channels[column].push_back(sent(run.t.back()));
    run.channels["pos.joint"].push_back(0);
  }
  return run;
}

std::vector<double> replayed(const Mechanism& robot, const Run& run) {
  const Trial trial = trialOf(run, robot);
  return replay(nominalPlant(*trial.robot), trial).values.at(0);
}

TEST(TrialOf, aJointWithoutAPositionGainIsDrivenBySpeedsAlone) {
  Mechanism robot = oneJoint();
  robot.joints[0].servo.kp = 0;
  const std::vector<double> positions = replayed(robot, runWith("cmd_vel.joint", [](double) { return 1.5; }));
  const double rate = (positions[190] - positions[90]) / 1;
  EXPECT_NEAR(rate, 1.5, 0.01) << "as soon as it has reached its speed";
}

TEST(TrialOf, theFrictionOfTheRobotsFileHoldsAJointThatTakesTorques) {
  const auto moved = [](double friction, double damping) {
    Mechanism robot = oneJoint();
    robot.joints[0].servo.kp = 0;
    robot.joints[0].servo.kd = 0;
    robot.joints[0].friction = friction;
    robot.joints[0].damping = damping;
    const std::vector<double> positions =
        replayed(robot, runWith("cmd_torque.joint", [](double) { return 0.1; }));
    return positions[199];
  };
  // 0.1 N m on 0.02 kg m^2 over two seconds.
  EXPECT_NEAR(moved(0, 0), 0.5 * 5 * 1.99 * 1.99, 0.1);
  EXPECT_NEAR(moved(0.05, 0), 0.5 * 2.5 * 1.99 * 1.99, 0.1);
  EXPECT_NEAR(moved(0.15, 0), 0, 1e-3);
  EXPECT_LT(moved(0, 0.1), 2) << "at most 1 rad/s";
}

TEST(TrialOf, anEffectAddsToTheFrictionOfTheRobotsFile) {
  Mechanism robot = oneJoint();
  robot.joints[0].friction = 0.05;
  EXPECT_DOUBLE_EQ(nominalPlant(robot).joints[0].coulomb, 0.05);
  EXPECT_DOUBLE_EQ(plantWith(robot, "coulomb_friction", "joint", 0.02).joints[0].coulomb, 0.07);
  robot.joints[0].damping = 0.3;
  EXPECT_DOUBLE_EQ(plantWith(robot, "viscous_friction", "joint", 0.1).joints[0].viscous, 0.4);
}

}  // namespace
}  // namespace plumbline::gap
