#pragma once
#include "field/FieldSize.h"
#include "math/Box2.h"
#include "math/Types.h"

namespace plumbline {

/// The own penalty area, in the team's frame [m]. It also holds what is behind it, where nobody walks.
class OwnArea {
public:
  /// How far from it those keep that have no right to be in it: here they wait, no nearer do they walk past
  /// it, nearer than the last they are on their way out.
  static constexpr double waitDistance = 0.6, passDistance = 0.3, leaveDistance = 0.25;

  explicit OwnArea(const FieldSize& field);

  /// How far a place is from it; negative: how deep it is within.
  double distance(const Vec2& place) const;
  /// The place, or the nearest one on the field that is `margin` from the area.
  Vec2 keptOut(const Vec2& place, double margin) const;
  /// The area and a margin around it.
  Box2 widened(double margin) const;
  /// A velocity with less of it towards the area, so that a robot stops before it, within brakeSeconds at
  /// least: field frame [m, m/s, s].
  Vec2 stoppedBefore(const Vec2& velocity, const Vec2& place, double brakeSeconds) const;

private:
  double front_, half_, line_;
};

}  // namespace plumbline
