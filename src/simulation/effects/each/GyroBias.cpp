#include "simulation/effects/LeagueEffect.h"

namespace plumbline::simulation {

namespace {

class BiasedGyro : public SensorEffect {
public:
  explicit BiasedGyro(const EffectSettings& settings) {
    for (const EffectSetting& setting : settings) bias_[axisOf(setting)] += setting.value;
  }
  void read(RobotReadings& readings, const JointArray&, bool) override { readings.gyro += bias_; }

private:
  Vec3 bias_ = Vec3::Zero();  // [rad/s]
};

}  // namespace

/// The gyroscope shows more than the true rate, in its own axes.
const LeagueEffect gyroBias{
    .id = "gyro_bias",
    .order = 250,
    .site = LeagueEffect::Site::imu,
    .axes = "xyz",
    .lower = -10,
    .upper = 10,
    .turn = 50,
    .sensor = [](const EffectSettings& settings, const EffectRobot&) -> std::unique_ptr<SensorEffect> {
      return std::make_unique<BiasedGyro>(settings);
    },
};
MAKE_LEAGUE_EFFECT(gyroBias);

}  // namespace plumbline::simulation
