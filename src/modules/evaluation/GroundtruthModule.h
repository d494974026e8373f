#pragma once
#include "framework/Module.h"
#include "representations/infrastructure/FrameInfo.h"
#include "representations/infrastructure/GroundTruth.h"
#include "representations/modeling/BallPos.h"
#include "representations/modeling/RobotPose.h"

namespace plumbline {

MODULE(GroundtruthModule)
  REQUIRES(FrameInfo)
  REQUIRES(GroundTruth)
  PROVIDES(RobotPose)
  PROVIDES(BallPos)
END_MODULE

/// The true pose and ball instead of the estimated ones, for experiments; only where modules.cfg asks for it
/// and the simulator sends it (its ground truth option).
class GroundtruthModule : public GroundtruthModuleBase {
public:
  void execute() override;
  void update(RobotPose* theRobotPose) override;
  void update(BallPos* theBallPos) override;

private:
  Pose2 robot_;
  Vec2 ballBefore_ = Vec2::Zero(), ballVelocity_ = Vec2::Zero();  ///< on the field
  bool seen_ = false;
  bool warned_ = false;
};

}  // namespace plumbline
