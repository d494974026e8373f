#pragma once
#include <functional>

#include "TwoJointArm.h"

namespace plumbline::gap {

namespace one {
inline constexpr double kp = 20, kd = 0.4, inertia = 0.02;  // of the joint [N m/rad, N m s/rad, kg m^2]
}  // namespace one

/// One joint without gravity whose link and rotor weigh 0.02 kg m^2 together: everything follows by hand. Its
/// servo has 20 N m/rad and 0.4 N m s/rad.
inline Mechanism oneJoint() {
  Mechanism robot = twoJointArm();
  robot.name = "one_joint";
  robot.links.resize(2);
  robot.joints.resize(1);
  robot.links[1].com.setZero();
  robot.links[1].inertia = Mat3::Identity() * 0.014;
  robot.joints[0].name = "joint";
  robot.joints[0].lower = -100;
  robot.joints[0].upper = 100;
  robot.joints[0].maxSpeed = 100;
  robot.gravity.setZero();
  return robot;
}

/// A trial of that joint at 100 Hz: position commanded over time; its position and its speed are read.
inline Trial oneJointTrial(const Mechanism& robot, double seconds,
                           const std::function<double(double t)>& command) {
  Trial trial = armTrial(robot, seconds);
  for (std::size_t k = 0; k < trial.cycles(); ++k) trial.command[0][k] = command(trial.time[k]);
  Signal speed = trial.signals[0];
  speed.name = "vel.joint";
  speed.kind = SignalKind::velocity;
  trial.signals[0].values.assign(trial.cycles(), trial.command[0][0]);
  trial.signals.push_back(speed);
  return trial;
}

/// The nominal plant with an effect at its joint.
inline Plant plantWith(const Mechanism& robot, const char* effect, const char* place, double value,
                       int variant = 0) {
  Plant plant = nominalPlant(robot);
  const Effect* of = findEffect(effect);
  of->apply(plant, findPlace(*of, robot, place, ""), value, variant);
  return plant;
}

}  // namespace plumbline::gap
