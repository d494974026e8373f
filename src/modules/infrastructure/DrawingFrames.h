#pragma once
#include "framework/Drawing.h"
#include "framework/Module.h"
#include "inspect/DrawingViewer.h"
#include "representations/infrastructure/PlayerInfo.h"
#include "representations/infrastructure/RobotDescription.h"
#include "representations/modeling/FKModel.h"
#include "representations/modeling/RobotPose.h"
#include "representations/modeling/TorsoPose.h"

namespace plumbline {

MODULE(DrawingFrames)
  REQUIRES(PlayerInfo)
  REQUIRES(RobotPose)
  REQUIRES(TorsoPose)
  REQUIRES(FKModel)
  REQUIRES(RobotDescription)
END_MODULE

/// Says where the robot is, so that every module of its thread can draw in the robot's own frames
/// (framework/Drawing.h), and whose drawings they are.
class DrawingFrames : public DrawingFramesBase {
public:
  void init() override { owner_ = findObject<inspect::DrawingOwner>(); }
  void execute() override;

private:
  void drawBody(Drawing& drawing) const;

  inspect::DrawingOwner* owner_ = nullptr;
};

}  // namespace plumbline
