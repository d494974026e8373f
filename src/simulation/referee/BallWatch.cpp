#include "simulation/referee/BallWatch.h"

#include <algorithm>
#include <cmath>

namespace plumbline::simulation {

using simspark::TeamSide;

namespace {

constexpr double tolerance = 0.001;  ///< the league server's [m]

/// Of the centre of a ball that is behind the goal line [m].
double goalLineOf(const FieldSize& field) { return field.length / 2 + field.ballRadius; }

bool betweenPosts(const FieldSize& field, double y, double z) {
  return std::fabs(y) < field.goalWidth / 2 && z < field.goalHeight;
}

/// Whether the ball reaches into the goal's inside.
bool insideGoal(const FieldSize& field, const Vec3& ball) {
  const Vec3 half((field.goalDepth - 2 * field.ballRadius) / 2, field.goalWidth / 2 - field.ballRadius,
                  field.goalHeight / 2);
  const Vec3 centre(field.length / 2 + field.goalDepth / 2, 0, field.goalHeight / 2);
  const Vec3 way(std::fabs(ball.x()) - centre.x(), ball.y(), ball.z() - centre.z());
  return (way.cwiseAbs() - half).cwiseMax(0).norm() < field.ballRadius;
}

}  // namespace

void BallWatch::update(const BodyState& ball, const std::vector<BallTouch>& touching) {
  current_ = ball.pose.translation();
  velocity_ = ball.linearVelocity;
  if (onField()) valid_ = current_;
  touching_ = touching;
  if (!touching_.empty()) lastTouch_ = touching_.front();
}

void BallWatch::placed(const Vec3& place) {
  current_ = place;
  velocity_.setZero();
}

void BallWatch::swapSides() {
  lastTouch_.side = simspark::opponent(lastTouch_.side);
  for (BallTouch& touch : touching_) touch.side = simspark::opponent(touch.side);
}

bool BallWatch::onField() const {
  return std::fabs(current_.x()) < goalLineOf(field_) + tolerance &&
         std::fabs(current_.y()) < field_.width / 2 + field_.ballRadius + tolerance;
}

bool BallWatch::touchedBy(TeamSide side) const {
  return std::any_of(touching_.begin(), touching_.end(),
                     [side](const BallTouch& touch) { return touch.side == side; });
}

TeamSide BallWatch::inGoalOf() const {
  const TeamSide side = current_.x() < 0 ? TeamSide::left : TeamSide::right;
  const double goalLine = goalLineOf(field_);
  if (insideGoal(field_, current_)) return side;
  if (std::fabs(current_.x()) < goalLine) return TeamSide::none;
  if (std::fabs(current_.x() - velocity_.x()) > goalLine) return TeamSide::none;  // it came from elsewhere
  const double line = std::copysign(goalLine, current_.x());
  const Vec3 crossing = current_ - velocity_ * ((current_.x() - line) / velocity_.x());
  return betweenPosts(field_, crossing.y(), crossing.z()) ? side : TeamSide::none;
}

}  // namespace plumbline::simulation
