#pragma once
#include "framework/Module.h"
#include "representations/infrastructure/FrameInfo.h"
#include "representations/modeling/BallPos.h"
#include "representations/modeling/RobotPose.h"

namespace plumbline {

MODULE(BeliefCombinator)
REQUIRES(FrameInfo)
REQUIRES(RobotPose)
REQUIRES(LocalBallPos)
PROVIDES(BallPos)
END_MODULE

/// The ball to act on: what this robot tracks, placed on the field.
class BeliefCombinator : public BeliefCombinatorBase {
public:
  void update(BallPos* theBallPos) override;
};

}  // namespace plumbline
