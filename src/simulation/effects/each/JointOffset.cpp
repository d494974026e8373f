#include "simulation/effects/LeagueEffect.h"

namespace plumbline::simulation {

namespace {

class EncoderOffsets : public SensorEffect {
public:
  explicit EncoderOffsets(const EffectSettings& settings) {
    for (int j = 0; j < maxJoints; ++j)
      offset_[static_cast<JointId>(j)] = sumOf(settingsAt(settings, static_cast<JointId>(j)));
  }
  void read(RobotReadings& readings, const JointArray&, bool) override {
    for (std::size_t j = 0; j < offset_.size(); ++j) readings.angle[j] -= offset_[j];
  }

private:
  JointArray offset_{};
};

}  // namespace

/// The encoder shows less than the motor's angle by this much.
const LeagueEffect jointOffset{
    .id = "joint_offset",
    .order = 190,
    .lower = -0.5,
    .upper = 0.5,
    .turn = 10,
    .sensor = [](const EffectSettings& settings, const EffectRobot&) -> std::unique_ptr<SensorEffect> {
      return std::make_unique<EncoderOffsets>(settings);
    },
};
MAKE_LEAGUE_EFFECT(jointOffset);

}  // namespace plumbline::simulation
