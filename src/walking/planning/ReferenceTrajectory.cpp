#include "walking/planning/ReferenceTrajectory.h"

#include <cmath>

#include "math/PlanarRoot.h"

namespace plumbline::walking {
namespace {

constexpr double velocityThreshold = 1e-4;  // [m/s]
constexpr int maxIterations = 5;

/// The step on the foot `support`. Each foot is at its place next to the centre of mass in the middle of
/// the time it carries. When walking sideways or turning the feet are placed further apart and splayed, so
/// that the step against the direction only closes the feet.
WalkAction stepOf(const Gait& gait, Side support) {
  const Side swing = other(support);
  const double half = gait.stepDuration / 2;
  const Pose2 place(-gait.copOffset.x(),
                    outward(swing) * (gait.feetDistance / 2 + std::abs(gait.velocity.y()) * half),
                    outward(swing) * std::abs(gait.turn) * half);
  WalkAction action;
  action.duration = gait.stepDuration;
  action.turn = gait.turn * gait.stepDuration;
  action.stepTarget = arc(gait.velocity, gait.turn, half) * place;
  return action;
}

}  // namespace

Pose2 arc(const Vec2& velocity, double turn, double time) {
  const double angle = turn * time;
  const double chord = std::abs(angle) < 1e-6 ? 1 : std::sin(angle / 2) / (angle / 2);
  return Pose2(Vec2(Eigen::Rotation2Dd(angle / 2) * velocity * (time * chord)), angle);
}

ReferenceTrajectory findReferenceTrajectory(const WalkModel& model, const Gait& gait) {
  ReferenceTrajectory reference;
  const WalkAction onLeft = reference.action[0] = stepOf(gait, Side::left);
  const WalkAction onRight = reference.action[1] = stepOf(gait, Side::right);

  WalkState& s0 = reference.begin[0];
  WalkState& s1 = reference.begin[1];
  s0.support = Support::left;
  s0.foot[0] = onRight.stepTarget;
  const PlanarRoot root = findPlanarRoot(
      [&](const Vec2& velocity) {
        s0.velocity = velocity;
        s1 = model.predict(s0, onLeft);
        return Vec2(model.predict(s1, onRight).velocity - velocity);
      },
      Vec2::Zero(), velocityThreshold, maxIterations);
  reference.iterations = root.evaluations;
  reference.error = root.error.norm();
  // The foot that swings in the first step is where the step before left it.
  s0.foot[1] = model.predict(s1, onRight).foot[1];
  s1 = model.predict(s0, onLeft);
  return reference;
}

}  // namespace plumbline::walking
