#include "gap/blind/OutsideDrives.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "gap/TwoJointArm.h"
#include "servo/BulletRobot.h"

namespace plumbline::gap {
namespace {

servo::BulletRobot onFixedBase(const Mechanism& arm, const std::vector<double>& q) {
  servo::RobotSimulationOptions config;
  config.fixedBase = true;
  config.stepSeconds = 0.0005;
  for (const Mechanism::Joint& joint : arm.joints) config.drives.push_back(JointPlant::nominal(joint));
  Mechanism fine = arm;
  fine.controlHz = 2000;
  servo::BulletRobot world(fine, config);
  world.restart(Pose3::Identity(), q);
  return world;
}

/// What goal joints at q get that were asked to be at `asked`, in the first slice or after so many seconds.
std::vector<double> commanded(const BlindEffect& effect, const std::vector<double>& q,
                              const std::vector<double>& asked, double time = 0, int slices = 1) {
  const Mechanism arm = twoJointArm();
  servo::BulletRobot world = onFixedBase(arm, q);
  OutsideDrives drives(arm, {effect});
  drives.start({0.1, 0.1});
  std::vector<double> targets;
  for (int i = 0; i < slices; ++i) {
    targets = asked;
    drives.act(time + i * 0.001, 0.001, world, targets);
  }
  return targets;
}

TEST(OutsideDrives, aGainThatFallsStepsAnIntegralAndANeighbour) {
  EXPECT_EQ(commanded({"acc_bias", "imu", "x", 1, {}}, {0.1, 0.1}, {0.3, 0.2}), (std::vector{0.3, 0.2}));
  EXPECT_NEAR(commanded({"gain_drift", "elbow", "", 0.5, {}}, {0.1, 0.1}, {0.3, 0.2}, 15)[1], 0.15, 1e-12);
  EXPECT_NEAR(commanded({"gain_drift", "elbow", "", 0.5, {}}, {0.1, 0.1}, {0.3, 0.2}, 7.5)[1], 0.175, 1e-12);
  EXPECT_NEAR(commanded({"command_resolution", "elbow", "", 0.03, {}}, {0.1, 0.1}, {0.3, 0.2})[1], 7 * 0.03,
              1e-12);
  EXPECT_NEAR(commanded({"command_resolution", "elbow", "", 0.03, {}}, {0.1, 0.1}, {0.3, -0.19})[1],
              -6 * 0.03, 1e-12);
  EXPECT_NEAR(commanded({"servo_integral", "elbow", "", 2, {}}, {0.1, 0.1}, {0.3, 0.2}, 0, 50)[1],
              0.2 + 2 * 0.1 * 0.05, 1e-12);
  EXPECT_NEAR(commanded({"servo_integral", "elbow", "", 2, {}}, {0.1, 0.1}, {0.3, 5.1}, 0, 5000)[1],
              5.1 + 3 / 20.0, 1e-12)
      << "no more than the servo's torque";
  EXPECT_NEAR(commanded({"crosstalk", "elbow", "", 0.2, {}}, {0.1, 0.1}, {0.3, 0.2})[1], 0.2 + 0.2 * 0.2,
              1e-12);
  EXPECT_EQ(commanded({"crosstalk", "elbow", "", 0.2, {}}, {0.1, 0.1}, {0.3, 0.2})[0], 0.3);
}

/// Where the elbow comes to rest, sent there from where it hangs straight down within 2 s.
double rest(const BlindEffect& effect, double target) {
  const Mechanism arm = twoJointArm();
  servo::BulletRobot world = onFixedBase(arm, {0, 0});
  OutsideDrives drives(arm, {effect});
  drives.start({0, 0});
  for (int i = 0; i < 8000; ++i) {
    std::vector<double> targets = {0, target * std::min(1.0, i / 4000.0)};
    drives.act(i * 0.0005, 0.0005, world, targets);
    world.command(targets);
    world.step();
  }
  return world.readings().position[1];
}

TEST(OutsideDrives, springsPullAndRipplesShift) {
  // 20 (target - q) - spring q - the weight of both links, as the shoulder gives way too.
  const double nominal = rest({"joint_spring", "elbow", "", 0, {}}, 0.5);
  const double spring = rest({"joint_spring", "elbow", "", 5, {}}, 0.5);
  EXPECT_NEAR((20 * (nominal - spring)) / (5 * spring), 1, 0.03);
  EXPECT_NEAR(rest({"cable_spring", "elbow", "", 5, {}}, 0.5), spring, 1e-6);
  EXPECT_NEAR(rest({"cable_spring", "elbow", "", 5, {}}, -0.5),
              rest({"cable_spring", "elbow", "", 0, {}}, -0.5), 1e-9);
  const double ripple = rest({"gear_ripple", "elbow", "", 0.4, {}}, 0.5);
  EXPECT_NEAR(20 * (ripple - nominal), 0.4 * std::sin(24 * ripple + 0.7), 0.03);
  EXPECT_NEAR(20 * (nominal - rest({"bristle_friction", "elbow", "", 0.3, {}}, 0.5)), 0.3, 0.03)
      << "bent as far as it gives since the start at 0";
}

TEST(OutsideDrives, dampingInOneDirectionSlowsThatOne) {
  const Mechanism arm = twoJointArm();
  const auto after = [&arm](double value, double target) {
    servo::BulletRobot world = onFixedBase(arm, {0, 0});
    OutsideDrives drives(arm, {{"asymmetric_damping", "elbow", "", value, {}}});
    drives.start({0, 0});
    for (int i = 0; i < 100; ++i) {
      std::vector<double> targets = {0, target};
      drives.act(i * 0.0005, 0.0005, world, targets);
      world.command(targets);
      world.step();
    }
    return world.readings().position[1];
  };
  EXPECT_LT(after(0.8, 0.3), 0.8 * after(0, 0.3));
  EXPECT_DOUBLE_EQ(after(0.8, -0.3), after(0, -0.3));
}

TEST(OutsideDrives, saysWhatItDoesNotKnow) {
  const Mechanism arm = twoJointArm();
  const auto error = [&arm](const BlindEffect& effect) -> std::string {
    try {
      const OutsideDrives drives(arm, {effect});
    } catch (const std::runtime_error& e) {
      return e.what();
    }
    return "nothing thrown";
  };
  EXPECT_EQ(error({"moon_phase", "elbow", "", 1, {}}), "no engine of this program has the effect moon_phase");
  EXPECT_EQ(error({"gear_ripple", "knee", "", 1, {}}), "gear_ripple: two_joint_arm has no joint knee");
}

}  // namespace
}  // namespace plumbline::gap
