#pragma once
#include <array>

#include "math/Pose2.h"
#include "robot/JointId.h"

namespace plumbline::walking {

/// Which feet carry the robot.
enum class Support { left, right, both };

constexpr std::size_t index(Side side) { return side == Side::left ? 0 : 1; }
constexpr Side other(Side side) { return side == Side::left ? Side::right : Side::left; }
/// +1 for left, -1 for right: the direction of y to the outside.
constexpr double outward(Side side) { return side == Side::left ? 1.0 : -1.0; }
constexpr Support supportOf(Side side) { return side == Side::left ? Support::left : Support::right; }

/// Walk state of section 4.2.1 (Seekircher 2015): feet and velocity in the frame of the centre of mass, whose
/// origin is its projection on the ground and whose x axis is the torso's heading.
struct WalkState {
  Support support = Support::both;
  std::array<Pose2, 2> foot;     ///< centres of the soles, left and right [m, rad]
  Vec2 velocity = Vec2::Zero();  ///< of the centre of mass over the ground [m/s]

  /// The foot that carries alone; undefined in double support.
  Side supportSide() const { return support == Support::right ? Side::right : Side::left; }
  const Pose2& supportFoot() const { return foot[index(supportSide())]; }
};

/// What happens from one walk state to the next.
struct WalkAction {
  double duration = 0;  ///< [s]
  double turn = 0;      ///< the torso turns by this until the end, at constant rate [rad]
  Pose2 stepTarget;     ///< single support: the swing foot at the end, in the centre of mass frame then
  Vec2 centerOfPressure = Vec2::Zero();  ///< double support: in the centre of mass frame at the start [m]
};

}  // namespace plumbline::walking
