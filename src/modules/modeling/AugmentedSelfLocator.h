#pragma once
#include <optional>

#include "framework/Drawing.h"
#include "framework/Module.h"
#include "modules/modeling/selflocator/PoseFilter.h"
#include "representations/infrastructure/FieldDimensions.h"
#include "representations/infrastructure/FrameInfo.h"
#include "representations/infrastructure/PlayerInfo.h"
#include "representations/modeling/FKModel.h"
#include "representations/modeling/FallState.h"
#include "representations/modeling/Odometry.h"
#include "representations/modeling/RobotPose.h"
#include "representations/modeling/TorsoPose.h"
#include "representations/perception/PolarPercepts.h"

namespace plumbline {

MODULE(AugmentedSelfLocator)
  REQUIRES(FrameInfo)
  REQUIRES(FieldDimensions)
  REQUIRES(PlayerInfo)
  REQUIRES(VisionInfo)
  REQUIRES(PolarLandmarkPercept)
  REQUIRES(PolarLinePercept)
  REQUIRES(TorsoPose)
  REQUIRES(FKModel)
  REQUIRES(FallState)
  REQUIRES(Odometry)
  PROVIDES(RobotPose)
  PARAMETER_GROUP(PoseFilter::Parameters, filter, "the particle filter")
  PARAMETER_GROUP(VisionModel, vision, "standard deviations of percepts")
END_MODULE

/// Where the robot is on the field: a particle filter over flags, goal posts and field lines (PoseFilter).
class AugmentedSelfLocator : public AugmentedSelfLocatorBase {
public:
  void parametersChanged() override;
  void init() override;
  void update(RobotPose* theRobotPose) override;

private:
  void start();
  void look();
  /// Landmarks and lines of the last image, from where the robot believes to be.
  void drawSeen(Drawing& drawing) const;

  std::optional<PoseFilter> filter_;
  bool leftSide_ = true;  ///< the side filter_ is for
  FieldView view_;
};

}  // namespace plumbline
