#pragma once
#include <optional>

#include "math/Pose2.h"
#include "robot/ExpectedRobot.h"

namespace plumbline {

/// A robot on its way somewhere, as far as that is known; team's frame [m, m/s, rad].
struct MovingRobot {
  Vec2 position = Vec2::Zero();
  Vec2 velocity = Vec2::Zero();
  std::optional<double> heading{};  ///< not known: the direction in which it walks
  std::optional<Pose2> place{};     ///< where it wants to stand; not known: it goes on for a while
  double getUpSeconds = 0;          ///< until it has got up [s]
};

/// How fast robots are [m/s, rad/s].
struct MovingSpeeds {
  double walk = expectedWalkSpeed;
  double turn = expectedTurnSpeed;
};

/// The robot some seconds later: nearer to its place, or where its velocity leads it within a second.
MovingRobot movedOn(const MovingRobot& robot, double seconds, const MovingSpeeds& speeds);

/// When a robot that goes to `to` from now on is there [s]: it gets up, turns and walks. At rest with no
/// known heading it need not turn.
double secondsTo(const MovingRobot& robot, const Vec2& to, const MovingSpeeds& speeds);

}  // namespace plumbline
