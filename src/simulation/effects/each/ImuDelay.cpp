#include <algorithm>
#include <cmath>
#include <deque>

#include "simulation/effects/LeagueEffect.h"

namespace plumbline::simulation {

namespace {

class DelayedImu : public SensorEffect {
public:
  explicit DelayedImu(double cycles) : cycles_(cycles) {}
  void read(RobotReadings& readings, const JointArray&, bool newCycle) override {
    if (newCycle || history_.empty()) history_.push_front({readings.gyro, readings.acc});
    const double whole = std::floor(cycles_), rest = cycles_ - whole;
    const auto n = static_cast<std::size_t>(whole);
    if (history_.size() > n + 2) history_.resize(n + 2);
    const auto at = [&](std::size_t i) -> const Measured& {
      return history_[std::min(i, history_.size() - 1)];
    };
    readings.gyro = (1 - rest) * at(n).gyro + rest * at(n + 1).gyro;
    readings.acc = (1 - rest) * at(n).acc + rest * at(n + 1).acc;
  }
  void restart() override { history_.clear(); }

private:
  struct Measured {
    Vec3 gyro, acc;
  };
  double cycles_;
  std::deque<Measured> history_;  ///< newest first
};

}  // namespace

/// Gyroscope and accelerometer show earlier values; several delays add up.
const LeagueEffect imuDelay{
    .id = "imu_delay",
    .order = 260,
    .site = LeagueEffect::Site::imu,
    .lower = 0,
    .upper = 1,
    .turn = 30,
    .sensor = [](const EffectSettings& settings, const EffectRobot& robot) -> std::unique_ptr<SensorEffect> {
      return std::make_unique<DelayedImu>(sumOf(settings) / robot.stepSeconds);
    },
};
MAKE_LEAGUE_EFFECT(imuDelay);

}  // namespace plumbline::simulation
