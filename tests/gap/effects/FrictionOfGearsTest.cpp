// Friction of gears against what follows by hand.
#include <gtest/gtest.h>

#include "../OneJoint.h"

namespace plumbline::gap {
namespace {

using one::inertia;
using one::kd;
using one::kp;

/// How the joint goes on after its motor is switched off.
struct Coasting {
  double speed;  ///< at that moment [rad/s]
  double way;    ///< in the 1.99 s that follow [rad]
};

Coasting coasts(const Plant& plant, double speed) {
  Trial trial = oneJointTrial(plant.mechanism, 3, [&](double t) { return speed * std::min(t, 1.0); });
  trial.stiffness[0].assign(trial.cycles(), 1);
  for (std::size_t k = 100; k < trial.cycles(); ++k) trial.stiffness[0][k] = 0;
  ReplayOptions fine;
  fine.step = 0.0005;
  const Prediction p = replay(plant, trial, fine);
  EXPECT_NEAR(p.values[1][100], speed, 0.03);
  return {p.values[1][100], p.values[0].back() - p.values[0][100]};
}

/// Position behind the command while the joint is moved at a slow speed against a torque on its link.
double lag(Plant plant, double speed, double torque) {
  plant.joints[0].biasForce = torque;
  const Trial trial = oneJointTrial(plant.mechanism, 3, [&](double t) { return speed * t; });
  const Prediction p = replay(plant, trial);
  // A command holds for a cycle: half a cycle behind the ramp in the mean.
  return speed * (trial.time[250] - 0.005) - p.values[0][250];
}

TEST(FrictionOfGearsTest, asymmetricFrictionStopsTheJointByItsDirection) {
  const Mechanism robot = oneJoint();
  const auto stopsBy = [&](const Plant& plant, double speed, double friction) {
    const Coasting c = coasts(plant, speed);
    // Energy: inertia speed^2 / 2 = friction * way.
    EXPECT_NEAR(std::abs(c.way), inertia * c.speed * c.speed / 2 / friction, 1e-3) << speed;
  };
  const Plant oneWay = plantWith(robot, "asymmetric_friction", "joint", 0.1, 1);
  stopsBy(oneWay, 2, 0.1);
  stopsBy(oneWay, -2, 0.05);
  const Plant otherWay = plantWith(robot, "asymmetric_friction", "joint", -0.1, 1);
  stopsBy(otherWay, 2, 0.05);
  stopsBy(otherWay, -2, 0.1);
  // Without any the other way it turns on and on.
  const Coasting on = coasts(plantWith(robot, "asymmetric_friction", "joint", 0.1, 0), -2);
  EXPECT_NEAR(on.way, 1.99 * on.speed, 1e-3);
}

TEST(FrictionOfGearsTest, asymmetricFrictionIsThatOfTheMeanWithAConstantTorque) {
  const Mechanism robot = oneJoint();
  const Trial trial = oneJointTrial(robot, 4, [](double t) { return 0.4 * std::sin(3 * t); });
  Plant same = nominalPlant(robot);
  same.joints[0].coulomb = 0.075;
  same.joints[0].biasForce = -0.025;
  const auto one = replay(plantWith(robot, "asymmetric_friction", "joint", 0.1, 1), trial).values,
             other = replay(same, trial).values;
  for (std::size_t k = 0; k < trial.cycles(); ++k) ASSERT_NEAR(one[0][k], other[0][k], 1e-9);
}

TEST(FrictionOfGearsTest, linkLoadFrictionIsAShareOfWhatTheLinkCarries) {
  const Plant plant = plantWith(oneJoint(), "link_load_friction", "joint", 0.3);
  // The motor carries the load of 0.5 N m and friction of 0.15; lowering it, friction helps.
  EXPECT_NEAR(lag(plant, 0.2, -0.5), (0.5 + 0.15 + kd * 0.2) / kp, 1e-4);
  EXPECT_NEAR(lag(plant, -0.2, -0.5), (0.5 - 0.15 - kd * 0.2) / kp, 1e-4);
}

TEST(FrictionOfGearsTest, loadFrictionOfTheMotorsTorqueGrowsByItself) {
  const Plant plant = plantWith(oneJoint(), "load_friction", "joint", 0.3, 2);
  // M = 0.5 + 0.3 (M - what the servo's damping takes is in M): M = 0.5 / (1 - 0.3), and / (1 + 0.3).
  EXPECT_NEAR(lag(plant, 0.2, -0.5), (0.5 / 0.7 + kd * 0.2) / kp, 1e-4);
  EXPECT_NEAR(lag(plant, -0.2, -0.5), (0.5 / 1.3 - kd * 0.2) / kp, 1e-4);
}

TEST(FrictionOfGearsTest, loadStribeckFrictionIsThereAtLowSpeedOnly) {
  const Plant plant = plantWith(oneJoint(), "load_stribeck_friction", "joint", 0.1, 0);
  const auto motor = [](double speed) { return 0.3 / (1 - 0.1 * std::exp(-std::pow(speed / 0.1, 2))); };
  EXPECT_NEAR(lag(plant, 0.03, -0.3), (motor(0.03) + kd * 0.03) / kp, 1e-4);
  EXPECT_NEAR(lag(plant, 0.3, -0.3), (0.3 + kd * 0.3) / kp, 1e-4);
}

TEST(FrictionOfGearsTest, quadraticLoadFrictionIsOfTheSmallerTorque) {
  const Plant plant = plantWith(oneJoint(), "quadratic_load_friction", "joint", 0.3, 0);
  const double e = std::exp(-0.09);
  EXPECT_NEAR(lag(plant, 0.03, -0.4), (0.4 + 0.3 * 0.16 * e + kd * 0.03) / kp, 1e-4);
  // The motor lowers it with M = 0.4 - 0.3 M^2 e.
  const double lowering = (std::sqrt(1 + 4 * 0.3 * e * 0.4) - 1) / (2 * 0.3 * e);
  EXPECT_NEAR(lag(plant, -0.03, -0.4), (lowering - kd * 0.03) / kp, 1e-4);
  const Plant driven = plantWith(oneJoint(), "quadratic_load_friction", "joint", 0.3, 2);
  EXPECT_NEAR(lag(driven, 0.03, -0.4), (0.4 + kd * 0.03) / kp, 3e-4) << "the motor drives, but for jerks";
}

}  // namespace
}  // namespace plumbline::gap
