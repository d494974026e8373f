#include <cmath>

#include "simulation/effects/LeagueEffect.h"

namespace plumbline::simulation {

namespace {

class NonlinearEncoders : public SensorEffect {
public:
  explicit NonlinearEncoders(const EffectSettings& settings) {
    for (int j = 0; j < maxJoints; ++j)
      amplitude_[static_cast<JointId>(j)] = sumOf(settingsAt(settings, static_cast<JointId>(j)));
  }
  void read(RobotReadings& readings, const JointArray& motorAngle, bool) override {
    for (std::size_t j = 0; j < amplitude_.size(); ++j)
      readings.angle[j] += amplitude_[j] * std::sin(motorAngle[j]);
  }

private:
  JointArray amplitude_{};
};

}  // namespace

/// Amplitude of an error that comes once a turn.
const LeagueEffect encoderNonlinearity{
    .id = "encoder_nonlinearity",
    .order = 200,
    .lower = -0.5,
    .upper = 0.5,
    .turn = 20,
    .sensor = [](const EffectSettings& settings, const EffectRobot&) -> std::unique_ptr<SensorEffect> {
      return std::make_unique<NonlinearEncoders>(settings);
    },
};
MAKE_LEAGUE_EFFECT(encoderNonlinearity);

}  // namespace plumbline::simulation
