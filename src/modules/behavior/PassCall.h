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
  PARAMETER(double, reach, 0.5, "m", Range(0, 2), "largest distance of the requesting player from the ball")
  PARAMETER(double, threat, 4, "m", Range(0, 20), "an opponent this near to the ball is worth asking")
  PARAMETER(double, goalDistance, 10, "m", Range(0, 40),
            "no request nearer to the opponents' goal: a goal after it counts only if a second player "
            "touches the ball")
END_MODULE

/// Requests pass mode (doc/reference/rules.md) if the striker is at the ball before an opponent and needs
/// time to kick. The referee refuses while an opponent is within 1 m, so the request is sent at once.
class PassCall : public PassCallBase {
public:
  void update(PassRequest* thePassRequest) override;
};

}  // namespace plumbline
