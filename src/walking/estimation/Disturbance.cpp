#include "walking/estimation/Disturbance.h"

#include <algorithm>
#include <cmath>

#include "math/Gravity.h"

namespace plumbline::walking {
namespace {

Vec2 carrying(const WalkState& s) {
  return s.support == Support::both ? Vec2((s.foot[0].position + s.foot[1].position) / 2)
                                    : s.supportFoot().position;
}

}  // namespace

void Disturbance::update(const WalkState& planned, const WalkState& observed, double phase, double height,
                         const WalkParameters& p, double dt) {
  const double rate = std::sqrt(earthGravity / height);
  now_ = {carrying(observed) - carrying(planned), observed.velocity - planned.velocity};
  if (p.observation.biasWindow > 0) {
    const auto part = static_cast<std::size_t>(std::clamp(phase, 0.0, 0.999) * parts);
    Difference& before = usual_[static_cast<std::size_t>(planned.support)][part];
    now_.foot -= before.foot;
    now_.velocity -= before.velocity;
    // Each part of a step comes once in two steps. A push must not be learnt as normal.
    const bool standing = planned.support == Support::both;
    const double passed = standing ? dt : 2 * p.step.duration;
    const double learnt = std::min(1.0, passed / p.observation.biasWindow) * (1 - share_);
    constexpr double maxOffset = 0.02;  // of the foot that is usual, and of the velocity in rate times it [m]
    before.foot += learnt * shortened(now_.foot, maxOffset);
    before.velocity += learnt * shortened(now_.velocity, maxOffset * rate);
  }
  capture_ = now_.velocity / rate - now_.foot;
  double share = 0;
  if (p.recovery.full > p.recovery.from)
    share = std::clamp((capture_.norm() - p.recovery.from) / (p.recovery.full - p.recovery.from), 0.0, 1.0);
  share_ = std::max(share, share_ - (p.recovery.fadeTime > 0 ? dt / p.recovery.fadeTime : 1));
}

}  // namespace plumbline::walking
