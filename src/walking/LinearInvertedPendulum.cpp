#include "walking/LinearInvertedPendulum.h"

#include <cmath>

namespace plumbline::walking {

LinearInvertedPendulum::LinearInvertedPendulum(double height, const Vec2& copOffset_)
    : k(std::sqrt(9.81 / height)), copOffset(copOffset_) {}

Vec2 LinearInvertedPendulum::pivot(const WalkState& state) const {
  return state.supportFoot() * Vec2(copOffset.x(), outward(state.supportSide()) * copOffset.y());
}

WalkState LinearInvertedPendulum::move(const WalkState& state, const WalkAction& action, double time) const {
  const Vec2 cop = state.support == Support::both ? action.centerOfPressure : pivot(state);
  const double c = std::cosh(k * time), s = std::sinh(k * time);
  const Vec2 com = cop - cop * c + state.velocity * (s / k);
  const Vec2 velocity = -cop * (k * s) + state.velocity * c;

  const double heading = action.duration > 0 ? action.turn * time / action.duration : 0;
  const Pose2 T_new_old = Pose2(com, heading).inverse();
  WalkState moved = state;
  for (Pose2& foot : moved.foot) foot = T_new_old * foot;
  moved.velocity = T_new_old.rotation() * velocity;
  return moved;
}

}  // namespace plumbline::walking
