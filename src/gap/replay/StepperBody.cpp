// What the sensors of a whole body read of a plant in motion: its IMU, the soles' force sensors, its true
// pose.
#include <array>

#include "gap/replay/SolePlate.h"
#include "gap/replay/Stepper.h"
#include "gap/replay/TruePose.h"

namespace plumbline::gap {

void Stepper::beginBody() {
  cycleTime_.clear();
  imuTime_.clear();
  gyro_.clear();
  specificForce_.clear();
  imuIsLate_ = trial_.freeBase && plant_.imu.delay > 0;
}

void Stepper::sampleImu(double t) {
  tree_.update(T_world_base_.linear(), q_.data() + tree_.baseSize(), v_.data());
  const Mechanism::Imu& imu = plant_.mechanism.imu;
  const bool carried = imu.link == 0 || trial_.freeBase;
  const Mat3 R_world_sensor = (carried ? tree_.rotation(imu.link) : Mat3(Mat3::Identity())) *
                              rotationOfRpy(imu.rpy) * plant_.imu.R_true_sensor;
  imuTime_.push_back(t);
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
}

void Stepper::readBody(std::size_t cycle, double t, const std::vector<std::size_t>& signals,
                       std::vector<std::vector<double>>& values) {
  cycleTime_.push_back(t);
  if (imuTime_.empty() || !imuIsLate_)
    sampleImu(t);
  else
    tree_.update(T_world_base_.linear(), q_.data() + tree_.baseSize(), v_.data());
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
  constexpr double rounding = 1e-9;  // [s]
  for (const std::size_t s : signals) {
    const Signal& signal = trial_.signals[s];
    const bool turning = signal.kind == SignalKind::gyro;
    if (!turning && signal.kind != SignalKind::accelerometer) continue;
    const std::vector<Vec3>& series = turning ? gyro_ : specificForce_;
    std::size_t at = 0;  // the sample at that time, or the first after it
    for (std::size_t k = 0; k < cycleTime_.size(); ++k) {
      const double when = cycleTime_[k] - plant_.imu.delay;
      while (at + 1 < imuTime_.size() && imuTime_[at] < when - rounding) ++at;
      double value = series[at][signal.axis];
      // A speed changes on a line within a step, an acceleration is that of the step.
      if (turning && at > 0 && imuTime_[at] > when) {
        const double share = (imuTime_[at] - when) / (imuTime_[at] - imuTime_[at - 1]);
        value += share * (series[at - 1][signal.axis] - value);
      }
      values[s][k] = value;
    }
  }
}

}  // namespace plumbline::gap
