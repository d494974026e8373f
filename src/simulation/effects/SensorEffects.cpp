#include "simulation/effects/SensorEffects.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "simulation/effects/EffectTable.h"

namespace plumbline::simulation {

namespace {

constexpr std::optional<FootForce> RobotReadings::*feet[] = {
    &RobotReadings::leftFoot, &RobotReadings::rightFoot, &RobotReadings::leftToe, &RobotReadings::rightToe};

}  // namespace

SensorEffects::SensorEffects(const std::vector<EffectSetting>& effects, double stepSeconds)
    : step_(stepSeconds) {
  const char* footNames[] = {"lFoot", "rFoot", "lToe", "rToe"};
  for (const EffectSetting& effect : effects) {
    const int axis = effect.axis.empty() ? 0 : effect.axis[0] - 'x';
    if (effect.effect == "imu_delay") delay_ += effect.value;
    if (effect.effect == "gyro_bias") gyroBias_[axis] += effect.value;
    if (effect.effect == "imu_misalignment")
      R_true_sensor_ = Eigen::AngleAxisd(effect.value, Vec3::Unit(axis)) * R_true_sensor_;
    for (int j = 0; j < maxJoints; ++j) {
      if (!isAt(effect, static_cast<JointId>(j))) continue;
      if (effect.effect == "joint_offset") offset_[static_cast<std::size_t>(j)] += effect.value;
      if (effect.effect == "encoder_nonlinearity") amplitude_[static_cast<std::size_t>(j)] += effect.value;
    }
    for (std::size_t f = 0; f < 4; ++f) {
      Link foot;
      foot.name = footNames[f];
      if (effect.effect == "fsr_gain" && isAt(effect, foot)) footGain_[f] *= effect.value;
    }
  }
}

RobotReadings SensorEffects::read(const RobotReadings& truth, const JointArray& slack, bool newCycle) {
  RobotReadings readings = truth;
  for (std::size_t j = 0; j < maxJoints; ++j) {
    const double motor = truth.angle[j] + slack[j];
    readings.angle[j] = motor - offset_[j] + amplitude_[j] * std::sin(motor);
  }
  if (newCycle || history_.empty()) history_.push_front({truth.gyro, truth.acc});
  const double cycles = delay_ / step_, whole = std::floor(cycles), rest = cycles - whole;
  const auto n = static_cast<std::size_t>(whole);
  if (history_.size() > n + 2) history_.resize(n + 2);
  const auto at = [&](std::size_t i) -> const Imu& { return history_[std::min(i, history_.size() - 1)]; };
  const auto turned = [&](Vec3 Imu::*part) {
    return Vec3(R_true_sensor_.transpose() * ((1 - rest) * (at(n).*part) + rest * (at(n + 1).*part)));
  };
  readings.gyro = turned(&Imu::gyro) + gyroBias_;
  readings.acc = turned(&Imu::acc);
  for (std::size_t f = 0; f < 4; ++f)
    if (auto& foot = readings.*feet[f]) foot->force *= footGain_[f];
  return readings;
}

}  // namespace plumbline::simulation
