#include "simulation/effects/SensorEffects.h"

#include "simulation/effects/LeagueEffect.h"

namespace plumbline::simulation {

SensorEffects::SensorEffects(const std::vector<EffectSetting>& effects, double stepSeconds,
                             std::uint64_t stream) {
  for (const auto& [effect, settings] : effectsInUse(effects))
    if (effect->sensor) effects_.push_back(effect->sensor(settings, {stepSeconds, stream}));
}

RobotReadings SensorEffects::read(const RobotReadings& truth, const JointArray& slack, bool newCycle) {
  RobotReadings readings = truth;
  JointArray motorAngle{};
  for (std::size_t j = 0; j < motorAngle.size(); ++j)
    readings.angle[j] = motorAngle[j] = truth.angle[j] + slack[j];
  for (const auto& effect : effects_) effect->read(readings, motorAngle, newCycle);
  return readings;
}

void SensorEffects::restart() {
  for (const auto& effect : effects_) effect->restart();
}

}  // namespace plumbline::simulation
