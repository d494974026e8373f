#pragma once
#include "framework/Module.h"
#include "representations/behavior/GoalieOutput.h"
#include "representations/behavior/PlayerRole.h"
#include "representations/infrastructure/FieldDimensions.h"
#include "representations/infrastructure/GameState.h"
#include "representations/modeling/BallPos.h"
#include "representations/modeling/RobotPose.h"

namespace plumbline {

MODULE(Goalie)
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
  PARAMETER(double, ballMaxAge, 4, "s", Range(0.1, 60), "a ball not seen for longer is searched")
END_MODULE

/// Stands on the line that halves the angle of the goal as the ball sees it, farther out the farther the
/// ball; steps into the way of a shot. Balls near the goal it clears as the striker, when Formation says so.
class Goalie : public GoalieBase {
public:
  void update(GoalieOutput* theGoalieOutput) override;

private:
  Vec2 onAngle() const;
  bool shotCrossing(Vec2& place) const;

  bool standing_ = false;
};

}  // namespace plumbline
