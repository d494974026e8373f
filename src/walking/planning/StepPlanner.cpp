#include "walking/planning/StepPlanner.h"

#include <algorithm>
#include <cmath>

#include "math/PlanarRoot.h"

namespace plumbline::walking {
namespace {

constexpr double settledVelocity = 1e-3;  // [m/s]
constexpr int mostCorrections = 4;
constexpr double inwardSplay =
    0.015;  // SimSpark's hip yaw pitch turns the toes inward by one degree only [rad]

}  // namespace

double StepPlanner::remainingTime(const WalkState& state, double elapsed, double turnRate, double nominal,
                                  double lateralVelocity) const {
  // The lateral velocity falls towards the swing side during the step; the time when it is that of the
  // reference.
  const double side = -outward(state.supportSide());
  const double shortest = std::max(0.0, limits_.minDuration - elapsed);
  const double longest = std::max(shortest, limits_.maxDuration - elapsed);
  const auto missing = [&](double time) {
    const WalkAction action{.duration = time, .turn = turnRate * time, .stepTarget = {}};
    return side * (lateralVelocity - model_.move(state, action, time).velocity.y());
  };
  double low = shortest, high = longest;
  double atLow = missing(low), atHigh = missing(high);
  if (atLow <= 0) return low;
  if (atHigh >= 0) return high;
  double time = std::clamp(nominal, low, high);
  for (int i = 0; i < 6; ++i) {
    const double error = missing(time);
    if (std::abs(error) < settledVelocity) break;
    (error > 0 ? low : high) = time;
    (error > 0 ? atLow : atHigh) = error;
    time = low + (high - low) * atLow / (atLow - atHigh);
  }
  return time;
}

Pose2 StepPlanner::limitTarget(const Pose2& target, const Pose2& support, Side swing) const {
  const double side = outward(swing);
  Pose2 limited = target;
  Vec2& p = limited.position;
  p.x() = std::clamp(p.x(), -limits_.backward, limits_.forward);
  double out = std::clamp(side * p.y(), -limits_.maxOutward, limits_.maxOutward);
  // Seen along the middle direction of both feet they keep their distance.
  const double heading = (normalizeAngle(target.heading) + support.heading) / 2;
  const Vec2 across = Eigen::Rotation2Dd(heading) * Vec2(0, side);
  const double distance = across.dot(Vec2(p.x(), side * out) - support.position);
  out += std::max(0.0, 2 * limits_.minOutward - distance) / std::max(0.5, side * across.y());
  p.y() = side * out;
  // The leg is long enough.
  const Vec2 hip(0, side * limits_.hipY);
  const Vec2 fromHip = p - hip;
  if (fromHip.norm() > limits_.reach) p = hip + fromHip * (limits_.reach / fromHip.norm());
  if (side * limited.heading < -inwardSplay) limited.heading = -side * inwardSplay;
  return limited;
}

WalkAction StepPlanner::step(const WalkState& state, double elapsed,
                             const ReferenceTrajectory& reference) const {
  const Side support = state.supportSide(), swing = other(support);
  const WalkAction& planned = reference.action[index(support)];
  const WalkAction& next = reference.action[index(swing)];
  const WalkState& end = reference.begin[index(swing)];

  const double nominal = std::max(0.0, planned.duration - elapsed);
  // The torso turns until the supporting foot has the heading it has at the end of the reference's step.
  const double turn = normalizeAngle(state.supportFoot().heading - end.foot[index(support)].heading);
  const double turnRate =
      std::clamp(turn / std::max(nominal, 0.02), -limits_.maxTurnRate, limits_.maxTurnRate);

  WalkAction action;
  action.duration = remainingTime(state, elapsed, turnRate, nominal, end.velocity.y());
  action.turn = turnRate * action.duration;
  action.stepTarget = planned.stepTarget;

  const WalkState landing = model_.predict(state, action);
  const Vec2 wanted = reference.begin[index(support)].velocity;
  const PlanarRoot root = findPlanarRoot(
      [&](const Vec2& position) {
        WalkState begin = landing;
        begin.foot[index(swing)].position = position;
        return Vec2(model_.predict(begin, next).velocity - wanted);
      },
      planned.stepTarget.position, settledVelocity, mostCorrections);
  if (root.x.allFinite()) action.stepTarget.position = root.x;
  action.stepTarget = limitTarget(action.stepTarget, landing.foot[index(support)], swing);
  return action;
}

Vec2 StepPlanner::limitPressure(const WalkState& state, const Vec2& point, double share) const {
  // The feet stand side by side: a rectangle about both, along the mean heading.
  const Vec2 middle = (state.foot[0].position + state.foot[1].position) / 2;
  const Eigen::Rotation2Dd turned((state.foot[0].heading + state.foot[1].heading) / 2);
  const Vec2 half = turned.inverse() * Vec2(state.foot[0].position - state.foot[1].position) / 2;
  const Vec2 bound(limits_.pressure.x() * share, (std::abs(half.y()) + limits_.pressure.y()) * share);
  const Vec2 local = turned.inverse() * Vec2(point - middle);
  return middle + turned * Vec2(local.cwiseMax(-bound).cwiseMin(bound));
}

WalkAction StepPlanner::start(const WalkState& state, double duration, Side first,
                              const ReferenceTrajectory& reference) const {
  const Side swing = other(first);
  WalkAction action;
  action.duration = duration;
  const WalkAction& step = reference.action[index(first)];
  const Vec2 wanted = reference.begin[index(swing)].velocity;
  const Vec2 middle = (state.foot[0].position + state.foot[1].position) / 2;
  const PlanarRoot root = findPlanarRoot(
      [&](const Vec2& pressure) {
        action.centerOfPressure = pressure;
        WalkState begin = model_.predict(state, action);
        begin.support = supportOf(first);
        return Vec2(model_.predict(begin, step).velocity - wanted);
      },
      middle, settledVelocity, mostCorrections);
  action.centerOfPressure = limitPressure(state, root.x.allFinite() ? root.x : middle, 1);
  return action;
}

Vec2 StepPlanner::calmingPressure(const WalkState& state) const {
  // After a short while the mass shall move to the middle, slower the nearer it is.
  const Vec2 middle = (state.foot[0].position + state.foot[1].position) / 2 + Vec2(limits_.restX, 0);
  WalkState both = state;
  both.support = Support::both;
  WalkAction action;
  action.duration = limits_.calmTime;
  const PlanarRoot root = findPlanarRoot(
      [&](const Vec2& pressure) {
        action.centerOfPressure = pressure;
        const WalkState end = model_.predict(both, action);
        const Vec2 middleThen = (end.foot[0].position + end.foot[1].position) / 2 + Vec2(limits_.restX, 0);
        return Vec2(end.velocity - limits_.calmRate * middleThen);
      },
      middle, settledVelocity, mostCorrections);
  return root.x.allFinite() ? root.x : middle;
}

WalkAction StepPlanner::stand(const WalkState& state, double duration) const {
  WalkAction action;
  action.duration = duration;
  action.centerOfPressure = limitPressure(state, calmingPressure(state), 1);
  return action;
}

bool StepPlanner::canHold(const WalkState& state, double margin) const {
  // Where the pressure must be to stop the mass: found with any model, from one pressure under the mass and
  // one next to it.
  WalkState both = state;
  both.support = Support::both;
  WalkAction action;
  action.duration = 1;
  const PlanarRoot root = findPlanarRoot(
      [&](const Vec2& pressure) {
        action.centerOfPressure = pressure;
        return model_.predict(both, action).velocity;
      },
      Vec2::Zero(), settledVelocity, mostCorrections);
  return !root.x.allFinite() || (root.x - limitPressure(state, root.x, 1)).norm() <= margin;
}

bool StepPlanner::canStand(const WalkState& state) const {
  // Tested with the model, with a reserve of pressure for what the model does not know.
  constexpr double cycle = 0.04, patience = 0.8, calm = 0.03;  // [s, s, m/s]
  WalkState tried = state;
  tried.support = Support::both;
  WalkAction action;
  action.duration = cycle;
  for (int i = 0; i * cycle < patience; ++i) {
    action.centerOfPressure = limitPressure(tried, calmingPressure(tried), 0.8);
    tried = model_.predict(tried, action);
    if (tried.velocity.norm() < calm) return true;
  }
  return false;
}

}  // namespace plumbline::walking
