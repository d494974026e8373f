#pragma once
#include <optional>

#include "framework/Module.h"
#include "representations/behavior/GoalieOutput.h"
#include "representations/behavior/PlayerRole.h"
#include "representations/infrastructure/FieldDimensions.h"
#include "representations/infrastructure/FrameInfo.h"
#include "representations/infrastructure/GameState.h"
#include "representations/modeling/BallPos.h"
#include "representations/modeling/RobotPose.h"

namespace plumbline {

MODULE(Goalie)
  REQUIRES(FrameInfo)
  REQUIRES(GameState)
  REQUIRES(FieldDimensions)
  REQUIRES(RobotPose)
  REQUIRES(BallPos)
  REQUIRES(PlayerRole)
  PROVIDES(GoalieOutput)
  PARAMETER(double, farOut, 1.6, "m", Range(0, 5), "distance from the goal for a ball far away")
  PARAMETER(double, nearOut, 0.5, "m", Range(0, 5), "distance from the goal for a ball close to it")
  PARAMETER(double, nearBall, 3, "m", Range(0, 30), "a ball this close to the goal counts as close")
  PARAMETER(double, farBall, 10, "m", Range(0.1, 60), "a ball this far from the goal counts as far away")
  PARAMETER(double, tolerance, 0.15, "m", Range(0.01, 2), "nearer to its place the goalie stands")
  PARAMETER(double, leaves, 0.3, "m", Range(0.01, 2), "farther from its place it walks there again")
  PARAMETER(double, shotSpeed, 0.8, "m/s", Range(0.1, 20), "a ball rolling faster at the goal is a shot")
  PARAMETER(bool, dives, true, "", Range(), "throws itself in the way of shots that it cannot step to")
  PARAMETER(double, standingReach, 0.2, "m", Range(0, 1),
            "a shot that passes it at this distance it stops as it stands")
  PARAMETER(double, diveReach, 0.9, "m", Range(0, 2),
            "to shots that pass it farther away than this it does not dive")
  PARAMETER(double, diveSeconds, 0.9, "s", Range(0.05, 5),
            "it waits for shots that pass it later than in this time")
  PARAMETER(
      double, sureSeconds, 0.1, "s", Range(0, 2),
      "it dives once a shot was for so long one to the same side: the first images show little of its way")
  PARAMETER(double, stepSpeed, 0.3, "m/s", Range(0, 3), "with which it walks to the side, after stepDelay")
  PARAMETER(double, stepDelay, 0.5, "s", Range(0, 5), "until it walks to the side")
  PARAMETER(double, ballMaxAge, 4, "s", Range(0.1, 60), "a ball not seen for longer is searched")
END_MODULE

/// Stands on the line that halves the angle of the goal as the ball sees it, farther out the farther the
/// ball; steps into the way of a shot, or dives. Balls near the goal it clears as the striker, when Formation
/// says so.
class Goalie : public GoalieBase {
public:
  void update(GoalieOutput* theGoalieOutput) override;

private:
  Vec2 onAngle() const;
  bool shotCrossing(Vec2& place) const;
  /// How far to the robot's left the ball will pass it, if only a dive reaches it there [m].
  std::optional<double> diveAside() const;

  bool standing_ = false;
  double sure_ = 0;  ///< for how long a dive to the left (+) or to the right (-) was wanted [s]
};

}  // namespace plumbline
