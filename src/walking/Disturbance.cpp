#include "walking/Disturbance.h"

#include <algorithm>
#include <cmath>

namespace plumbline::walking {
namespace {

Vec2 carrying(const WalkState& s) {
  return s.support == Support::both ? Vec2((s.foot[0].position + s.foot[1].position) / 2)
                                    : s.supportFoot().position;
}

}  // namespace

void Disturbance::update(const WalkState& planned, const WalkState& observed, double phase, double height,
                         const WalkParameters& p, double dt) {
  const double rate = std::sqrt(9.81 / height);
  now = {carrying(observed) - carrying(planned), observed.velocity - planned.velocity};
  if (p.usualAverage > 0) {
    const auto part = static_cast<std::size_t>(std::clamp(phase, 0.0, 0.999) * parts);
    Difference& before = usual[static_cast<std::size_t>(planned.support)][part];
    now.foot -= before.foot;
    now.velocity -= before.velocity;
    // Each part of a step comes once in two steps. A push is not to be learnt as usual.
    const bool standing = planned.support == Support::both;
    const double passed = standing ? dt : 2 * p.stepDuration;
    const double learnt = std::min(1.0, passed / p.usualAverage) * (1 - share_);
    constexpr double most = 0.02;  // [m]
    before.foot += learnt * shortened(now.foot, most);
    before.velocity += learnt * shortened(now.velocity, most * rate);
  }
  capture = now.velocity / rate - now.foot;
  double share = 0;
  if (p.recoverFull > p.recoverFrom)
    share = std::clamp((capture.norm() - p.recoverFrom) / (p.recoverFull - p.recoverFrom), 0.0, 1.0);
  share_ = std::max(share, share_ - (p.recoverTime > 0 ? dt / p.recoverTime : 1));
}

}  // namespace plumbline::walking
