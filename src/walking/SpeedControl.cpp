#include "walking/SpeedControl.h"

#include <algorithm>
#include <cmath>

namespace plumbline::walking {
namespace {

constexpr double nearlyFull = 0.9;  ///< share of the full speed that is meant to be a sprint
constexpr double aside = 0.2;       ///< share of the mixable speeds that may be asked for beside it

double approach(double value, double goal, double maxChange) {
  return value + std::clamp(goal - value, -maxChange, maxChange);
}

double mixed(double mix, double most) { return mix > 0 ? std::min(mix, most) : most; }

/// Speeds that may be mixed, and those of a sprint, when going forward or backward.
Vec3 mixLimits(double forward, const WalkParameters& p) {
  return {forward < 0 ? mixed(p.mixBackward, p.maxBackward) : mixed(p.mixForward, p.maxForward),
          mixed(p.mixSideways, p.maxSideways), mixed(p.mixTurn, p.maxTurn)};
}
Vec3 fullLimits(double forward, const WalkParameters& p) {
  return {forward < 0 ? p.maxBackward : p.maxForward, p.maxSideways, p.maxTurn};
}

/// How much is asked for beside an axis, as a share of what may be mixed.
double beside(const Vec3& speeds, const Vec3& mix, int axis) {
  Vec3 others = speeds.cwiseQuotient(mix);
  others[axis] = 0;
  return others.norm();
}

Vec3 withinMixture(const Vec3& wish, const Vec3& mix) {
  return wish / std::max(1.0, wish.cwiseQuotient(mix).norm());
}

}  // namespace

void SpeedControl::begin(const Vec2& goal, const WalkParameters& p) {
  const double least = std::clamp(goal.x(), -p.startSpeed, p.startSpeed);
  if (std::abs(now.x()) < std::abs(least)) now.x() = least;
}

int SpeedControl::sprintAxis(const Vec3& wish, const WalkParameters& p) const {
  const Vec3 mix = mixLimits(wish.x(), p), most = fullLimits(wish.x(), p);
  for (int i = 0; i < 3; ++i) {
    if (std::abs(wish[i]) < nearlyFull * most[i] || mix[i] >= most[i]) continue;
    const Vec3 scaled = wish / std::max(1.0, std::abs(wish[i]) / most[i]);
    if (beside(scaled, mix, i) <= aside) return i;
  }
  return -1;
}

Vec3 SpeedControl::feasible(const Vec3& wish, const WalkParameters& p, double dt) {
  if (axis >= 0) return sprint(wish, p, dt);
  const int could = sprintAxis(wish, p);
  patience = could == wished ? patience + dt : 0;
  wished = could;
  const Vec3 mix = mixLimits(wish.x(), p);
  if (could >= 0 && patience >= p.sprintPatience) {
    const double sign = wish[could] > 0 ? 1 : -1;
    if (sign * now[could] >= nearlyFull * mix[could] && beside(now, mix, could) <= aside) {
      axis = could;
      falling = false;
      full = sign * fullLimits(wish.x(), p)[could];
      settled = 0;
      return sprint(wish, p, dt);
    }
    // First at the speed of mixtures, in this direction alone.
    Vec3 go = straight(withinMixture(wish, mix), mix, could, p.sprintAside);
    go[could] = sign * mix[could];
    return go;
  }
  return withinMixture(wish, mix);
}

/// The wish with a share of the mixable speeds at most beside an axis.
Vec3 SpeedControl::straight(const Vec3& wish, const Vec3& mix, int axis, double share) {
  Vec3 go = wish;
  for (int i = 0; i < 3; ++i)
    if (i != axis) go[i] = std::clamp(go[i], -share * mix[i], share * mix[i]);
  return go;
}

Vec3 SpeedControl::sprint(const Vec3& wish, const WalkParameters& p, double dt) {
  const double sign = full > 0 ? 1 : -1;
  const Vec3 mix = mixLimits(axis == 0 ? full : wish.x(), p);
  Vec3 go = wish / std::max(1.0, std::abs(wish[axis] / full));
  if (sign * wish[axis] < nearlyFull * std::abs(full) || beside(go, mix, axis) > aside) falling = true;
  if (falling && sign * now[axis] <= mix[axis]) {
    if (settled >= p.sprintSettle - 1e-9) {
      axis = wished = -1;
      return withinMixture(wish, mixLimits(wish.x(), p));
    }
    settled += dt;
  }
  go = straight(go, mix, axis, p.sprintAside);
  go[axis] = falling ? sign * std::clamp(sign * go[axis], 0.0, mix[axis]) : full;
  return go;
}

/// Acceleration between the speed of mixtures and that of the sprint.
double SpeedControl::sprintRate(double usual, const WalkParameters& p) const {
  const double mix = mixLimits(axis == 0 ? full : 0, p)[axis], time = falling ? p.sprintFall : p.sprintRise;
  return time > 0 && std::abs(now[axis]) >= mix ? (std::abs(full) - mix) / time : usual;
}

void SpeedControl::update(const Vec2& goal, double turn, const WalkParameters& p, double calm, double dt) {
  const Vec3 target = calm * feasible(Vec3(goal.x(), goal.y(), turn), p, dt);
  const bool braking = std::abs(target.x()) < std::abs(now.x()) || target.x() * now.x() < 0;
  Vec3 rate(braking ? p.decelerationForward : p.accelerationForward, p.accelerationSideways,
            p.accelerationTurn);
  if (axis >= 0) rate[axis] = sprintRate(rate[axis], p);
  const double before = now.x();
  for (int i = 0; i < 3; ++i) now[i] = approach(now[i], target[i], rate[i] * dt);
  constexpr double average = 0.1;  // about a step [s]
  acceleration_ += std::min(1.0, dt / average) * ((now.x() - before) / dt - acceleration_);
  // The robot brakes before it turns: what forward speed leaves of the effort limits the rest.
  const Vec3 mix = mixLimits(now.x(), p);
  const double used = std::abs(now.x()) / mix.x();
  const double rest = std::max(axis == 0 ? p.sprintAside : 0.0, 1 - used);
  const double side = std::hypot(now.y() / mix.y(), now.z() / mix.z());
  if (side > rest && axis <= 0) {
    now.y() *= rest / side;
    now.z() *= rest / side;
  }
}

}  // namespace plumbline::walking
