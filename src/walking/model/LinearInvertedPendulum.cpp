#include "walking/model/LinearInvertedPendulum.h"

#include <algorithm>
#include <cmath>

#include "math/Gravity.h"

namespace plumbline::walking {
namespace {

double rate(double height) {
  constexpr double lowest = 0.02;
  return std::sqrt(earthGravity / std::max(lowest, height));
}

}  // namespace

LinearInvertedPendulum::LinearInvertedPendulum(const Vec2& heights, const Vec2& copOffset,
                                               const ModelParameters& fit)
    : plainRate_(rate(heights.x()), rate(heights.y())),
      copOffset_(copOffset),
      fitted_{{rate(heights.x() + fit.massOffsetZx), rate(heights.y() + fit.massOffsetZy)},
              fit.timeFactor,
              {fit.massOffsetX, fit.massOffsetY},
              {fit.velocityOffsetX, fit.velocityOffsetY},
              fit.footFactor * Vec2(fit.footFactorX, fit.footFactorY)} {}

Vec2 LinearInvertedPendulum::pivot(const WalkState& state) const {
  return state.supportFoot() * Vec2(copOffset_.x(), outward(state.supportSide()) * copOffset_.y());
}

WalkState LinearInvertedPendulum::move(const WalkState& state, const WalkAction& action, double time) const {
  // The parameters are of steps on one foot; nobody has tested them on a robot that stands.
  if (state.support == Support::both)
    return move(state, action.centerOfPressure, action, time,
                {plainRate_, 1, Vec2::Zero(), Vec2::Zero(), Vec2::Ones()});
  return move(state, pivot(state), action, time, fitted_);
}

WalkState LinearInvertedPendulum::move(const WalkState& state, const Vec2& cop, const WalkAction& action,
                                       double time, const Coefficients& c) {
  Vec2 com, velocity;  // moved way and velocity at the end, in the frame at the start
  for (int i = 0; i < 2; ++i) {
    const double k = c.rate[i], t = k * c.timeFactor * time, ch = std::cosh(t), sh = std::sinh(t);
    const double x = c.massOffset[i] - c.footFactor[i] * cop[i];  // of the mass from the centre of pressure
    const double v = state.velocity[i] + c.velocityOffset[i];
    com[i] = (x * (ch - 1) + v / k * sh) / c.footFactor[i];
    velocity[i] = x * k * sh + v * ch - c.velocityOffset[i];
  }

  const double heading = action.duration > 0 ? action.turn * time / action.duration : 0;
  const Pose2 T_new_old = Pose2(com, heading).inverse();
  WalkState moved = state;
  for (Pose2& foot : moved.foot) foot = T_new_old * foot;
  moved.velocity = T_new_old.rotation() * velocity;
  return moved;
}

}  // namespace plumbline::walking
