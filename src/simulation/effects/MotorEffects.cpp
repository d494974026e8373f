#include "simulation/effects/MotorEffects.h"

#include <algorithm>
#include <cmath>

#include "simulation/effects/EffectTable.h"

namespace plumbline::simulation {

MotorEffects::MotorEffects(const std::vector<EffectSetting>& effects, double stepSeconds,
                           std::uint64_t stream)
    : step_(stepSeconds), random_(1, stream) {
  for (const EffectSetting& effect : effects) {
    if (effect.effect == "command_dropout") dropout_ = effect.value;
    for (int j = 0; j < maxJoints; ++j) {
      if (!isAt(effect, static_cast<JointId>(j))) continue;
      Path& path = paths_[static_cast<std::size_t>(j)];
      path.used = true;
      if (effect.effect == "command_delay")
        path.delay += effect.value;
      else if (effect.effect == "servo_gain")
        path.gain *= effect.value;
      else if (effect.effect == "acceleration_limit")
        path.acceleration = effect.value;
      else if (effect.effect == "profile_speed")
        path.fastest = std::min(path.fastest, effect.value);
      else if (effect.effect == "backlash")
        path.play += effect.value;
      else
        path.used = path.delay != 0 || path.gain != 1 || path.acceleration != 0 || path.play != 0 ||
                    std::isfinite(path.fastest);
    }
  }
}

void MotorEffects::beginCycle() {
  lost_ = lossy() && random_.uniform(0, 1) < dropout_;
  if (!lost_) arrived_ = commanded_;
}

double MotorEffects::velocity(JointId joint) {
  Path& path = paths_[joint];
  // Over a step the motor turns at the mean of the commands that are in force during it.
  const double cycles = path.delay / step_, whole = std::floor(cycles), rest = cycles - whole;
  const auto n = static_cast<std::size_t>(whole);
  path.sent.push_front(arrived_[joint]);
  if (path.sent.size() > n + 2) path.sent.resize(n + 2);
  const auto at = [&](std::size_t i) { return i < path.sent.size() ? path.sent[i] : 0; };
  double speed = path.gain * ((1 - rest) * at(n) + rest * at(n + 1));
  speed = std::clamp(speed, -path.fastest, path.fastest);
  if (path.acceleration > 0)
    speed = std::clamp(speed, path.speed - path.acceleration * step_, path.speed + path.acceleration * step_);
  path.speed = speed;
  if (path.play > 0) {
    const double moved = path.slack + speed * step_;
    path.slack = std::clamp(moved, -path.play / 2, path.play / 2);
    speed = (moved - path.slack) / step_;
  }
  return speed;
}

void MotorEffects::restart() {
  commanded_.fill(0);
  arrived_.fill(0);
  for (Path& path : paths_) {
    path.sent.clear();
    path.speed = path.slack = 0;
  }
}

}  // namespace plumbline::simulation
