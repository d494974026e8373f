#pragma once
#include <optional>

#include "framework/Module.h"
#include "modules/modeling/ground/TorsoHeight.h"
#include "representations/infrastructure/FrameInfo.h"
#include "representations/infrastructure/RobotDescription.h"
#include "representations/modeling/FKModel.h"
#include "representations/modeling/GroundContactState.h"
#include "representations/modeling/TorsoAngles.h"
#include "representations/modeling/TorsoPose.h"

namespace plumbline {

MODULE(TorsoPoseProvider)
REQUIRES(FrameInfo)
REQUIRES(RobotDescription)
REQUIRES(FKModel)
REQUIRES(TorsoAngles)
REQUIRES(UprightVec)
REQUIRES(GroundContactState)
PROVIDES(TorsoPose)
END_MODULE

/// Tilt and height of the torso over the ground: the lowest point of the feet touches it, or, when the robot
/// lies, the lowest point of its body.
class TorsoPoseProvider : public TorsoPoseProviderBase {
public:
  void init() override;
  void update(TorsoPose* theTorsoPose) override;

private:
  double lyingTilt_ = 0;      ///< [rad]
  double contactMemory_ = 0;  ///< [s]
  int type_ = -1;
  std::optional<TorsoHeight> height_;
  double withoutContact_ = 0;  ///< [s]
};

}  // namespace plumbline
