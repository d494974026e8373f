#include "tactics/ChargeGuard.h"

#include <algorithm>
#include <cmath>

namespace plumbline {

Vec2 ChargeGuard::allowed(Vec2 velocity, const Vec2& ball, const std::vector<Vec2>& opponents,
                          const ChargeGuardParameters& p, double dt) {
  sinceTouch_ = ball.norm() < p.touchDistance ? 0 : sinceTouch_ + dt;
  if (sinceTouch_ < p.immunity) return velocity;
  for (const Vec2& opponent : opponents) {
    const double distance = opponent.norm();
    if (distance < 1e-3 || ball.norm() < (opponent - ball).norm() + p.nearerBy) continue;
    const Vec2 to = opponent / distance;
    const double towards = velocity.dot(to);
    if (towards <= std::cos(p.widestAngle) * velocity.norm()) continue;
    const double most = std::max(p.leastSpeed, (distance - p.contactDistance) / p.contactSeconds);
    if (towards > most) velocity -= (towards - most) * to;
  }
  return velocity;
}

}  // namespace plumbline
