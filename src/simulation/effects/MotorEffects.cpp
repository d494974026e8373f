#include "simulation/effects/MotorEffects.h"

#include <algorithm>

#include "simulation/effects/LeagueEffect.h"

namespace plumbline::simulation {

MotorEffects::MotorEffects(const std::vector<EffectSetting>& effects, double stepSeconds,
                           std::uint64_t stream) {
  for (const auto& [effect, settings] : effectsInUse(effects))
    if (effect->command) effects_.push_back(effect->command(settings, {stepSeconds, stream}));
}

bool MotorEffects::touches(JointId joint) const {
  return std::ranges::any_of(effects_, [&](const auto& effect) { return effect->touches(joint); });
}

void MotorEffects::beginCycle() {
  arrived_ = commanded_;
  for (const auto& effect : effects_) effect->cycle(arrived_);
}

double MotorEffects::slack(JointId joint) const {
  double slack = 0;
  for (const auto& effect : effects_) slack += effect->slack(joint);
  return slack;
}

void MotorEffects::restart() {
  commanded_.fill(0);
  arrived_.fill(0);
  for (const auto& effect : effects_) effect->restart();
}

}  // namespace plumbline::simulation
