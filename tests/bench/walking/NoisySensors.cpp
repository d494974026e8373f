#include "bench/walking/NoisySensors.h"

#include <algorithm>
#include <cmath>

namespace plumbline::bench {
namespace {

constexpr double encoderStep = 2 * 3.14159265358979323846 / 4096, encoderNoise = 3e-4;  // [rad]
constexpr double gyroNoise = 0.005, accNoise = 0.06, forceNoise = 0.15;                 // [rad/s, m/s^2, N]

}  // namespace

NoisySensors::NoisySensors(std::unique_ptr<simulation::RobotSimulation> robot_) : robot(std::move(robot_)) {
  sense();
}

void NoisySensors::restart(const Pose3& T_world_base, const std::vector<double>& q) {
  robot->restart(T_world_base, q);
  random = Random(1);
  sense();
}

void NoisySensors::restart(const std::vector<double>& q, double heading) {
  robot->restart(q, heading);
  random = Random(1);
  sense();
}

void NoisySensors::step() {
  robot->step();
  sense();
}

void NoisySensors::sense() {
  noisy = robot->readings();
  angles.resize(noisy.position.size());
  for (std::size_t j = 0; j < angles.size(); ++j)
    angles[j] = encoderStep * std::round(robot->encoder(static_cast<int>(j)) / encoderStep) +
                encoderNoise * random.gaussian();
  for (int axis = 0; axis < 3; ++axis) {
    noisy.gyro[axis] += gyroNoise * random.gaussian();
    noisy.acc[axis] += accNoise * random.gaussian();
  }
  for (std::vector<double>& foot : noisy.footForce)
    for (double& force : foot) force = std::max(0.0, force + forceNoise * random.gaussian());
}

}  // namespace plumbline::bench
