// What the sensors of a whole body read of a plant in motion: its IMU, the soles' force sensors, its true
// pose.
#include <array>

#include "gap/replay/SolePlate.h"
#include "gap/replay/Stepper.h"
#include "gap/replay/TruePose.h"

namespace plumbline::gap {

void Stepper::beginBody() {
  bodyTime_.clear();
  gyro_.clear();
  specificForce_.clear();
}

void Stepper::readBody(std::size_t cycle, double t, const std::vector<std::size_t>& signals,
                       std::vector<std::vector<double>>& values) {
  tree_.update(T_world_base_.linear(), q_.data() + tree_.baseSize(), v_.data());
  const Mechanism::Imu& imu = plant_.mechanism.imu;
  const bool carried = imu.link == 0 || trial_.freeBase;
  const Mat3 R_world_sensor = (carried ? tree_.rotation(imu.link) : Mat3(Mat3::Identity())) *
                              rotationOfRpy(imu.rpy) * plant_.imu.R_true_sensor;
  bodyTime_.push_back(t);
  if (trial_.freeBase) {
    gyro_.emplace_back(R_world_sensor.transpose() * tree_.angularVelocity(imu.link));
    const Vec3 point = tree_.origin(imu.link) + tree_.rotation(imu.link) * imu.accelerometer;
    specificForce_.emplace_back(R_world_sensor.transpose() *
                                tree_.specificForceAt(imu.link, point, acceleration_.data()));
  } else {
    gyro_.emplace_back(Vec3::Zero());
    specificForce_.emplace_back(-(R_world_sensor.transpose() * plant_.mechanism.gravity));
  }
  gyro_.back() += plant_.imu.gyroBias;
  if (!trial_.freeBase) return;

  const std::array<double, 7> pose = poseValues(T_world_base_);
  std::vector<std::vector<double>> feet(plant_.mechanism.feet.size());
  for (const std::size_t s : signals) {
    const Signal& signal = trial_.signals[s];
    if (signal.kind == SignalKind::truth) values[s][cycle] = pose[index(signal.axis)];
    if (signal.kind != SignalKind::force) continue;
    auto& shares = feet[index(signal.place)];
    if (shares.empty()) {
      const Contacts::FootForce total = contacts_->footForce(signal.place, tree_);
      shares = plateForces(plant_.mechanism.feet[index(signal.place)], total.normal, total.centre);
      for (double& share : shares) share *= plant_.footGain[index(signal.place)];
    }
    values[s][cycle] = shares[index(signal.axis)];
  }
}

void Stepper::endBody(const std::vector<std::size_t>& signals,
                      std::vector<std::vector<double>>& values) const {
  for (const std::size_t s : signals) {
    const Signal& signal = trial_.signals[s];
    if (signal.kind != SignalKind::gyro && signal.kind != SignalKind::accelerometer) continue;
    const std::vector<Vec3>& series = signal.kind == SignalKind::gyro ? gyro_ : specificForce_;
    std::size_t at = 0;
    for (std::size_t k = 0; k < bodyTime_.size(); ++k) {
      const double when = bodyTime_[k] - plant_.imu.delay;
      while (at + 1 < bodyTime_.size() && bodyTime_[at + 1] <= when) ++at;
      double value = series[at][signal.axis];
      if (at + 1 < bodyTime_.size() && when > bodyTime_[at]) {
        const double share = (when - bodyTime_[at]) / (bodyTime_[at + 1] - bodyTime_[at]);
        value += share * (series[at + 1][signal.axis] - value);
      }
      values[s][k] = value;
    }
  }
}

}  // namespace plumbline::gap
