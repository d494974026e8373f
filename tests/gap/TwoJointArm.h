#pragma once
#include <cmath>
#include <memory>
#include <string>
#include <vector>

#include "gap/diagnosis/Explanation.h"
#include "gap/replay/Replay.h"
#include "gap/replay/Trial.h"
#include "math/Random.h"
#include "robot/Mechanism.h"

namespace plumbline::gap {

/// A pendulum of two links under gravity, 0.2 m each, point-like masses at their ends: small enough to work
/// out by hand. Joints "shoulder" and "elbow" about y, base fixed.
inline Mechanism twoJointArm() {
  Mechanism arm;
  arm.name = "two_joint_arm";
  arm.links.push_back({"base", -1, 1, Vec3::Zero(), Mat3::Identity() * 0.01});
  for (int i = 0; i < 2; ++i) {
    arm.links.push_back({i ? "lower" : "upper", i, i ? 0.2 : 0.3, Vec3(0, 0, -0.2), Mat3::Identity() * 1e-5});
    Mechanism::Joint joint;
    joint.name = i ? "elbow" : "shoulder";
    joint.parent = i;
    joint.child = i + 1;
    joint.origin = i ? Vec3(0, 0, -0.2) : Vec3(0, 0, 0.5);
    joint.axis = Vec3::UnitY();
    joint.lower = -3;
    joint.upper = 3;
    joint.maxTorque = 3;
    joint.maxSpeed = 7;
    joint.servo.kp = 20;
    joint.servo.kd = 0.4;
    joint.servo.armature = 0.006;
    arm.joints.push_back(joint);
  }
  return arm;
}

/// An effect at a joint or link of a robot, in its first variant.
inline Cause causeOf(const Mechanism& robot, const char* id, const char* place, double value) {
  const Effect* effect = findEffect(id);
  return {effect, findPlace(*effect, robot, place, ""), value, 0};
}

inline Cause causeOfArm(const char* id, const char* place, double value) {
  return causeOf(twoJointArm(), id, place, value);
}

/// A trial of 100 Hz in which both joints follow sums of sines of that size, then steps, then slow reversals.
inline Trial armTrial(const Mechanism& arm, double seconds = 12, double size = 0.5) {
  Trial trial;
  trial.name = "arm";
  trial.motion = "sines, steps, slow reversals";
  trial.robot = std::make_shared<Mechanism>(arm);
  const std::size_t n = arm.joints.size();
  trial.command.resize(n);
  trial.stiffness.resize(n);
  trial.voltage.resize(n);
  trial.commandAt.assign(n, 0);
  trial.positionAt.assign(n, 0);
  trial.velocityAt.assign(n, 0);
  for (int k = 0; k < static_cast<int>(100 * seconds); ++k) {
    const double t = 0.01 * k, third = seconds / 3;
    trial.time.push_back(t);
    for (std::size_t j = 0; j < n; ++j) {
      const double a = size * (j ? 0.8 : 1), w = j ? 1.3 : 1;
      double command = 0;
      if (t < third)
        command = a * (std::sin(2 * M_PI * 0.5 * w * t) + 0.3 * std::sin(2 * M_PI * 2.1 * w * t));
      else if (t < 2 * third)
        command = std::fmod(t, 1.0) < 0.5 ? a : -a;
      else
        command = a * std::asin(std::sin(2 * M_PI * 0.35 * w * t));
      trial.command[j].push_back(command);
    }
  }
  for (std::size_t j = 0; j < n; ++j) {
    Signal signal;
    signal.name = "pos." + arm.joints[j].name;
    signal.joint = static_cast<int>(j);
    signal.values.assign(trial.cycles(), 0);
    trial.signals.push_back(signal);
  }
  return trial;
}

/// Puts what the plant would show into the trial, with noise.
inline Trial recorded(const Plant& plant, Trial trial, double noise, std::uint64_t seed,
                      const ReplayOptions& options = {}) {
  for (Signal& signal : trial.signals) signal.values.assign(trial.cycles(), 0);
  for (std::size_t j = 0; j < trial.command.size(); ++j) trial.signals[j].values[0] = trial.targets(j)[0];
  const Prediction prediction = replay(plant, trial, options);
  Random random(seed);
  for (std::size_t s = 0; s < trial.signals.size(); ++s)
    for (std::size_t k = 0; k < trial.cycles(); ++k)
      trial.signals[s].values[k] = prediction.values[s][k] + noise * random.gaussian();
  return trial;
}

/// Of so many cycles: whether a command was lost, each with that probability.
inline std::vector<std::uint8_t> drawnLosses(std::size_t cycles, double share, std::uint64_t seed) {
  Random random(seed);
  std::vector<std::uint8_t> lost(cycles, 0);
  for (auto& cycle : lost) cycle = random.uniform() < share;
  return lost;
}

/// A motion, six seconds of the arm's, recorded twice, each time with another such share of the commands
/// lost.
inline std::vector<Trial> recordedTwice(const Plant& plant, double noise, double lostShare,
                                        const Trial& motion = armTrial(twoJointArm(), 6)) {
  std::vector<Trial> trials;
  for (const std::uint64_t seed : {11, 12}) {
    const std::vector<std::uint8_t> lost = drawnLosses(motion.cycles(), lostShare, seed);
    ReplayOptions options;
    options.lostCycles = &lost;
    trials.push_back(recorded(plant, motion, noise, seed, options));
  }
  for (std::size_t t = 0; t < trials.size(); ++t) trials[t].recording = "run" + std::to_string(t);
  return trials;
}

}  // namespace plumbline::gap
