#pragma once
#include "framework/Module.h"
#include "representations/behavior/PassRequest.h"
#include "representations/behavior/PlayerRole.h"
#include "representations/infrastructure/FieldDimensions.h"
#include "representations/infrastructure/GameState.h"
#include "representations/modeling/BallPos.h"
#include "representations/modeling/OtherRobots.h"
#include "representations/modeling/RobotPose.h"

namespace plumbline {

MODULE(PassCall)
  REQUIRES(GameState)
  REQUIRES(PlayerRole)
  REQUIRES(FieldDimensions)
  REQUIRES(RobotPose)
  REQUIRES(BallPos)
  REQUIRES(OtherRobots)
  PROVIDES(PassRequest)
  PARAMETER(double, reach, 0.5, "m", Range(0, 2), "who asks is this near to the ball")
  PARAMETER(double, threat, 4, "m", Range(0, 20), "an opponent this near to the ball is worth asking")
  PARAMETER(double, goalDistance, 10, "m", Range(0, 40),
            "nearer to the opponents' goal nobody asks: a goal after it counts only when a second player "
            "touches the ball")
END_MODULE

/// Asks for pass mode (doc/reference/rules.md) where the striker is at the ball before an opponent and needs
/// time to kick. The referee refuses while an opponent is within 1 m, so asking at once pays.
class PassCall : public PassCallBase {
public:
  void update(PassRequest* thePassRequest) override;
};

}  // namespace plumbline
