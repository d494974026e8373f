#pragma once
#include "framework/Module.h"
#include "representations/behavior/PlayerRole.h"
#include "representations/behavior/SupporterOutput.h"
#include "representations/infrastructure/FrameInfo.h"
#include "representations/infrastructure/GameState.h"
#include "representations/modeling/BallPos.h"
#include "representations/modeling/RobotPose.h"
#include "tactics/BallSearch.h"

namespace plumbline {

MODULE(Supporter)
  REQUIRES(FrameInfo)
  REQUIRES(GameState)
  REQUIRES(RobotPose)
  REQUIRES(BallPos)
  REQUIRES(PlayerRole)
  PROVIDES(SupporterOutput)
  PARAMETER(double, ballMaxAge, 4, "s", Range(0.1, 60), "a ball that no player saw for longer is searched")
  PARAMETER(double, arrived, 0.35, "m", Range(0.05, 3), "nearer to its place the player stands")
  PARAMETER(double, leaves, 0.7, "m", Range(0.05, 5), "farther from its place it walks there again")
  PARAMETER(double, facing, 0.5, "rad", Range(0.05, 3.2), "a standing player turns to a ball farther aside")
END_MODULE

/// Goes to the place that Formation gives and faces the ball. Stands still while that is near enough, so that
/// it sees well and falls less.
class Supporter : public SupporterBase {
public:
  void update(SupporterOutput* theSupporterOutput) override;

private:
  BallSearch search_;
  bool standing_ = false;
};

}  // namespace plumbline
