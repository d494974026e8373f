#include "tactics/OwnArea.h"

#include <algorithm>
#include <cmath>

namespace plumbline {
namespace {

constexpr double behindTheGoal = 100;  ///< [m]
constexpr double insideField = 0.4;    ///< places stay this far inside the goal line [m]

}  // namespace

OwnArea::OwnArea(const FieldSize& field)
    : front_(field.penaltyDepth - field.length / 2),
      half_(field.penaltyWidth / 2),
      line_(-field.length / 2) {}

double OwnArea::distance(const Vec2& place) const {
  const double ahead = place.x() - front_, aside = std::abs(place.y()) - half_;
  if (ahead <= 0 || aside <= 0) return std::max(ahead, aside);
  return std::hypot(ahead, aside);
}

Vec2 OwnArea::keptOut(const Vec2& place, double margin) const {
  if (distance(place) >= margin) return place;
  const Vec2 before(front_ + margin, place.y());
  const Vec2 beside(std::max(place.x(), line_ + insideField), std::copysign(half_ + margin, place.y()));
  return (before - place).norm() <= (beside - place).norm() ? before : beside;
}

Box2 OwnArea::widened(double margin) const {
  return {{line_ - behindTheGoal, -half_ - margin}, {front_ + margin, half_ + margin}};
}

Vec2 OwnArea::stoppedBefore(const Vec2& velocity, const Vec2& place, double brakeSeconds) const {
  const double away = distance(place);
  if (away <= 0) return velocity;  // it has to leave, by whatever way
  const Vec2 edge(std::min(place.x(), front_), std::clamp(place.y(), -half_, half_));
  const Vec2 to = (edge - place) / away;
  const double towards = velocity.dot(to), most = std::max(0.0, (away - leaveDistance) / brakeSeconds);
  return towards > most ? Vec2(velocity - (towards - most) * to) : velocity;
}

}  // namespace plumbline
