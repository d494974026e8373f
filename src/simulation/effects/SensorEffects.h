#pragma once
#include <deque>
#include <vector>

#include "simulation/world/EffectFile.h"
#include "simulation/world/World.h"

namespace plumbline::simulation {

/// What one robot's sensors make of the truth: joint_offset, encoder_nonlinearity, imu_misalignment,
/// gyro_bias, imu_delay, fsr_gain.
class SensorEffects {
public:
  SensorEffects(const std::vector<EffectSetting>& effects, double stepSeconds);

  /// Readings as the robot gets them. slack: per joint, what the encoder on the motor's side of a gear with
  /// play shows beyond the link's angle [rad]. newCycle: a step has passed since the last call.
  RobotReadings read(const RobotReadings& truth, const JointArray& slack, bool newCycle);
  void restart() { history_.clear(); }

private:
  struct Imu {
    Vec3 gyro, acc;
  };
  double step_, delay_ = 0;
  JointArray offset_{}, amplitude_{};
  Mat3 R_true_sensor_ = Mat3::Identity();
  Vec3 gyroBias_ = Vec3::Zero();
  double footGain_[4] = {1, 1, 1, 1};  ///< left and right foot, left and right toe
  std::deque<Imu> history_;            ///< newest first
};

}  // namespace plumbline::simulation
