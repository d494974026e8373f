#include "walking/LinearInvertedPendulum.h"

#include <algorithm>
#include <cmath>

namespace plumbline::walking {
namespace {

double rate(double height) {
  constexpr double gravity = 9.81, lowest = 0.02;
  return std::sqrt(gravity / std::max(lowest, height));
}

}  // namespace

LinearInvertedPendulum::LinearInvertedPendulum(const Vec2& heights, const Vec2& copOffset_,
                                               const ModelParameters& fit)
    : k(rate(heights.x() + fit.massOffsetZx), rate(heights.y() + fit.massOffsetZy)),
      copOffset(copOffset_),
      massOffset(fit.massOffsetX, fit.massOffsetY),
      velocityOffset(fit.velocityOffsetX, fit.velocityOffsetY),
      footFactor(fit.footFactor * Vec2(fit.footFactorX, fit.footFactorY)),
      timeFactor(fit.timeFactor) {}

Vec2 LinearInvertedPendulum::pivot(const WalkState& state) const {
  return state.supportFoot() * Vec2(copOffset.x(), outward(state.supportSide()) * copOffset.y());
}

WalkState LinearInvertedPendulum::move(const WalkState& state, const WalkAction& action, double time) const {
  const Vec2 cop = state.support == Support::both ? action.centerOfPressure : pivot(state);
  Vec2 com, velocity;  // moved way and velocity at the end, in the frame at the start
  for (int i = 0; i < 2; ++i) {
    const double t = k[i] * timeFactor * time, c = std::cosh(t), s = std::sinh(t);
    const double x = massOffset[i] - footFactor[i] * cop[i];  // of the mass from the centre of pressure
    const double v = state.velocity[i] + velocityOffset[i];
    com[i] = (x * (c - 1) + v / k[i] * s) / footFactor[i];
    velocity[i] = x * k[i] * s + v * c - velocityOffset[i];
  }

  const double heading = action.duration > 0 ? action.turn * time / action.duration : 0;
  const Pose2 T_new_old = Pose2(com, heading).inverse();
  WalkState moved = state;
  for (Pose2& foot : moved.foot) foot = T_new_old * foot;
  moved.velocity = T_new_old.rotation() * velocity;
  return moved;
}

}  // namespace plumbline::walking
