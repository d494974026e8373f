#include "bench/walking/NoisySensors.h"

#include <algorithm>
#include <cmath>

namespace plumbline::bench {
namespace {

constexpr double encoderStep = 2 * 3.14159265358979323846 / 4096, encoderNoise = 3e-4;  // [rad]
constexpr double gyroNoise = 0.005, accNoise = 0.06, forceNoise = 0.15;                 // [rad/s, m/s^2, N]

}  // namespace

NoisySensors::NoisySensors(std::unique_ptr<servo::RobotSimulation> robot) : robot_(std::move(robot)) {
  sense();
}

void NoisySensors::restart(const Pose3& T_world_base, const std::vector<double>& q) {
  robot_->restart(T_world_base, q);
  random_ = Random(1);
  sense();
}

void NoisySensors::restart(const std::vector<double>& q, double heading) {
  robot_->restart(q, heading);
  random_ = Random(1);
  sense();
}

void NoisySensors::step() {
  robot_->step();
  sense();
}

void NoisySensors::sense() {
  noisy_ = robot_->readings();
  angles_.resize(noisy_.position.size());
  for (std::size_t j = 0; j < angles_.size(); ++j)
    angles_[j] = encoderStep * std::round(robot_->encoder(static_cast<int>(j)) / encoderStep) +
                 encoderNoise * random_.gaussian();
  for (int axis = 0; axis < 3; ++axis) {
    noisy_.gyro[axis] += gyroNoise * random_.gaussian();
    noisy_.acc[axis] += accNoise * random_.gaussian();
  }
  for (std::vector<double>& foot : noisy_.footForce)
    for (double& force : foot) force = std::max(0.0, force + forceNoise * random_.gaussian());
}

}  // namespace plumbline::bench
