#include "simulation/effects/LeagueEffect.h"

namespace plumbline::simulation {

namespace {

class ScaledForces : public SensorEffect {
public:
  explicit ScaledForces(const EffectSettings& settings) {
    for (const EffectSetting& setting : settings)
      for (Foot& foot : feet_)
        if (samePlace(setting.at, foot.name)) foot.gain *= setting.value;
  }
  void read(RobotReadings& readings, const JointArray&, bool) override {
    for (const Foot& foot : feet_)
      if (auto& sensor = readings.*foot.sensor) sensor->force *= foot.gain;
  }

private:
  struct Foot {
    std::string_view name;
    std::optional<FootForce> RobotReadings::*sensor;
    double gain = 1;
  };
  Foot feet_[4] = {{"lFoot", &RobotReadings::leftFoot},
                   {"rFoot", &RobotReadings::rightFoot},
                   {"lToe", &RobotReadings::leftToe},
                   {"rToe", &RobotReadings::rightToe}};
};

}  // namespace

/// Factor on what a foot's force sensor shows.
const LeagueEffect fsrGain{
    .id = "fsr_gain",
    .order = 270,
    .site = LeagueEffect::Site::foot,
    .lower = 0,
    .upper = 10,
    .turn = 60,
    .sensor = [](const EffectSettings& settings, const EffectRobot&) -> std::unique_ptr<SensorEffect> {
      return std::make_unique<ScaledForces>(settings);
    },
};
MAKE_LEAGUE_EFFECT(fsrGain);

}  // namespace plumbline::simulation
