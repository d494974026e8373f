#include "walking/planning/Sprint.h"

#include <cmath>

namespace plumbline::walking {
namespace {

constexpr double nearlyFull = 0.9;  ///< share of the full speed that is meant to be a sprint
constexpr double straight = 0.2;  ///< share of the omnidirectional limits that may be asked for off the axis

/// The axis along which a request wants to sprint, -1: none.
int sprintAxis(const Vec3& wish, const WalkParameters& p) {
  const Vec3 omni = omniLimits(wish.x(), p), most = fullLimits(wish.x(), p);
  for (int i = 0; i < 3; ++i) {
    if (std::abs(wish[i]) < nearlyFull * most[i] || omni[i] >= most[i]) continue;
    const Vec3 scaled = wish / std::max(1.0, std::abs(wish[i]) / most[i]);
    if (shareOffAxis(scaled, omni, i) <= straight) return i;
  }
  return -1;
}

/// The speed with a share of the omnidirectional limits at most off the axis.
Vec3 straightened(Vec3 speed, const Vec3& omni, int axis, double share) {
  for (int i = 0; i < 3; ++i)
    if (i != axis) speed[i] = std::clamp(speed[i], -share * omni[i], share * omni[i]);
  return speed;
}

}  // namespace

SprintState nextSprintState(SprintState state, const SprintConditions& c) {
  switch (state) {
    case SprintState::none:
    case SprintState::preparing:
      if (!c.asked) return SprintState::none;
      return c.ready ? SprintState::running : SprintState::preparing;
    case SprintState::running:
      return c.asked ? SprintState::running : SprintState::braking;
    case SprintState::braking:
      return c.slow ? SprintState::settling : SprintState::braking;
    case SprintState::settling:
      return c.slow && c.settled ? SprintState::none : SprintState::settling;
  }
  return state;
}

Vec3 Sprint::target(const Vec3& wish, const Vec3& now, const WalkParameters& p, double dt) {
  return active() ? along(wish, now, p, dt) : slower(wish, now, p, dt);
}

Vec3 Sprint::slower(const Vec3& wish, const Vec3& now, const WalkParameters& p, double dt) {
  const int could = sprintAxis(wish, p);
  patience_ = could == wished_ ? patience_ + dt : 0;
  wished_ = could;
  const Vec3 omni = omniLimits(wish.x(), p);
  const double sign = could >= 0 && wish[could] > 0 ? 1 : -1;
  SprintConditions conditions;
  conditions.asked = could >= 0 && patience_ >= p.sprint.patience;
  conditions.ready = could >= 0 && sign * now[could] >= nearlyFull * omni[could] &&
                     shareOffAxis(now, omni, could) <= straight;
  state_ = nextSprintState(state_, conditions);
  if (state_ == SprintState::running) {
    axis_ = could;
    full_ = sign * fullLimits(wish.x(), p)[could];
    settled_ = 0;
    return along(wish, now, p, dt);
  }
  const Vec3 mixed = withinEllipsoid(wish, omni);
  if (state_ == SprintState::none) return mixed;
  Vec3 go = straightened(mixed, omni, could, p.sprint.lateralShare);
  go[could] = sign * omni[could];
  return go;
}

Vec3 Sprint::along(const Vec3& wish, const Vec3& now, const WalkParameters& p, double dt) {
  const double sign = full_ > 0 ? 1 : -1;
  const Vec3 omni = omniLimits(axis_ == 0 ? full_ : wish.x(), p);
  Vec3 go = wish / std::max(1.0, std::abs(wish[axis_] / full_));
  SprintConditions conditions;
  conditions.asked =
      !(sign * wish[axis_] < nearlyFull * std::abs(full_) || shareOffAxis(go, omni, axis_) > straight);
  conditions.slow = sign * now[axis_] <= omni[axis_];
  conditions.settled = settled_ >= p.sprint.settleTime - 1e-9;
  for (SprintState before = SprintState::none; before != state_ && state_ != SprintState::none;) {
    before = state_;
    state_ = nextSprintState(state_, conditions);
  }
  if (state_ == SprintState::none) {
    axis_ = wished_ = -1;
    return withinEllipsoid(wish, omniLimits(wish.x(), p));
  }
  if (state_ == SprintState::settling && conditions.slow) settled_ += dt;
  go = straightened(go, omni, axis_, p.sprint.lateralShare);
  const bool running = state_ == SprintState::running;
  go[axis_] = running ? full_ : sign * std::clamp(sign * go[axis_], 0.0, omni[axis_]);
  return go;
}

double Sprint::acceleration(double usual, const Vec3& now, const WalkParameters& p) const {
  const double omni = omniLimits(axis_ == 0 ? full_ : 0, p)[axis_];
  const double time = state_ == SprintState::running ? p.sprint.riseTime : p.sprint.fallTime;
  return time > 0 && std::abs(now[axis_]) >= omni ? (std::abs(full_) - omni) / time : usual;
}

}  // namespace plumbline::walking
