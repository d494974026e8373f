#include <Eigen/Geometry>

#include "simulation/effects/LeagueEffect.h"

namespace plumbline::simulation {

namespace {

class TurnedImu : public SensorEffect {
public:
  explicit TurnedImu(const EffectSettings& settings) {
    for (const EffectSetting& setting : settings)
      R_true_sensor_ = Eigen::AngleAxisd(setting.value, Vec3::Unit(axisOf(setting))) * R_true_sensor_;
  }
  void read(RobotReadings& readings, const JointArray&, bool) override {
    readings.gyro = R_true_sensor_.transpose() * readings.gyro.eval();
    readings.acc = R_true_sensor_.transpose() * readings.acc.eval();
  }

private:
  Mat3 R_true_sensor_ = Mat3::Identity();
};

}  // namespace

/// Gyroscope and accelerometer are turned about an axis; several turn them one after another.
const LeagueEffect imuMisalignment{
    .id = "imu_misalignment",
    .order = 240,
    .site = LeagueEffect::Site::imu,
    .axes = "xyz",
    .lower = -3.2,
    .upper = 3.2,
    .turn = 40,
    .sensor = [](const EffectSettings& settings, const EffectRobot&) -> std::unique_ptr<SensorEffect> {
      return std::make_unique<TurnedImu>(settings);
    },
};
MAKE_LEAGUE_EFFECT(imuMisalignment);

}  // namespace plumbline::simulation
